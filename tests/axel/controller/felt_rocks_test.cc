// A rover rolls over rocks and along slopes; what it feels against where they are.
#include "controller/axel/felt_rocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dockyard::axel {
namespace {

constexpr double kTrack_m = 0.8, kWheelRadius_m = 0.3;
const RockLimits kLimits{};

// Of a wheel's lowest point over a flat rock with upright sides, its middle at x_m, for a wheel
// above wheel_m on a line through it.
double LiftOver(double x_m, double half_m, double rock_m, double wheel_m) {
  const double past_m = std::max(0.0, std::abs(wheel_m - x_m) - half_m);
  if (past_m >= kWheelRadius_m) return 0.0;
  const double fall_m =
      kWheelRadius_m - std::sqrt(kWheelRadius_m * kWheelRadius_m - past_m * past_m);
  return std::max(0.0, rock_m - fall_m);
}

// Rocks felt on the way of a rover along +x of O, which lies at X_DO, with the left wheel over a
// rock at 1 m, its heading turning by turn_rad a metre.
std::vector<MappedRock> Drive(const Pose2& X_DO, double from_m, double rock_m,
                              double slope_rad = 0.0, double turn_rad = 0.0) {
  FeltRocks felt(kTrack_m, {}, kLimits);
  std::vector<MappedRock> rocks;
  for (double way_m = from_m; way_m < from_m + 3.0; way_m += 0.001) {
    const Pose2 X_OR{way_m, 0.0, turn_rad * way_m};
    const double lift_m = LiftOver(1.0, 0.08, rock_m, way_m);
    const Attitude attitude{std::asin(lift_m / kTrack_m) + slope_rad * std::cos(X_OR.heading), 0.0};
    if (const auto rock = felt.Take(attitude, X_OR, X_DO * X_OR)) rocks.push_back(*rock);
  }
  return rocks;
}

TEST(FeltRocks, PlacesTheRockThatAWheelHasRolledOver) {
  const Pose2 X_DO{4.0, 1.0, 2.5};
  const std::vector<MappedRock> rocks = Drive(X_DO, 0.0, 0.08);
  ASSERT_EQ(rocks.size(), 1u);
  const Eigen::Vector2d rock = X_DO * Eigen::Vector2d(1.0, 0.5 * kTrack_m);
  EXPECT_LT(std::hypot(rocks[0].x_m - rock.x(), rocks[0].y_m - rock.y()), 0.08 + 1e-3);
  EXPECT_NEAR(rocks[0].height_m, 0.08, 1e-3);
}

TEST(FeltRocks, FeelsTheRockOnWhichItStarts) {
  const std::vector<MappedRock> rocks = Drive({}, 1.0, 0.09);
  ASSERT_EQ(rocks.size(), 1u);
  EXPECT_NEAR(rocks[0].x_m, 1.0, 0.08 + 1e-3);
  EXPECT_NEAR(rocks[0].y_m, 0.5 * kTrack_m, 1e-9);
}

TEST(FeltRocks, AWheelMayGoBackOverARockThatItHasStoodOn) {
  const std::vector<MappedRock> rocks = Drive({}, 0.0, 0.14);
  ASSERT_EQ(rocks.size(), 1u);
  EXPECT_LE(rocks[0].height_m, kLimits.wheel_climbs_m);
  EXPECT_GT(rocks[0].height_m, kLimits.body_clears_m);
}

TEST(FeltRocks, LeavesOutWhatTheBodyClears) {
  EXPECT_TRUE(Drive({}, 0.0, 0.9 * kLimits.body_clears_m).empty());
}

TEST(FeltRocks, TakesNoSlopeForARock) {
  for (const double turn_rad : {0.0, 0.3, 1.0, 2.0, 5.0}) {
    EXPECT_TRUE(Drive({}, 0.0, 0.0, Radians(10.0), turn_rad).empty()) << turn_rad;
  }
}

TEST(FeltRocks, TheRightWheelsRockLiesOnTheRight) {
  FeltRocks felt(kTrack_m, {}, kLimits);
  std::vector<MappedRock> rocks;
  for (double way_m = 0.0; way_m < 2.0; way_m += 0.001) {
    const Attitude attitude{-std::asin(LiftOver(1.0, 0.08, 0.08, way_m) / kTrack_m), 0.0};
    const Pose2 X_DR{way_m, 0.0, 0.0};
    if (const auto rock = felt.Take(attitude, X_DR, X_DR)) rocks.push_back(*rock);
  }
  ASSERT_EQ(rocks.size(), 1u);
  EXPECT_NEAR(rocks[0].y_m, -0.5 * kTrack_m, 1e-9);
}

TEST(FeltRocks, ASightingThatMovesThePoseMovesTheRockWithIt) {
  FeltRocks felt(kTrack_m, {}, kLimits);
  std::vector<MappedRock> rocks;
  for (double way_m = 0.0; way_m < 2.0; way_m += 0.001) {
    const Attitude attitude{std::asin(LiftOver(1.0, 0.08, 0.08, way_m) / kTrack_m), 0.0};
    const Pose2 X_OR{way_m, 0.0, 0.0};
    const Pose2 X_DO{way_m < 1.1 ? 5.0 : 5.2, 0.0, 0.0};  // while the wheel comes down
    if (const auto rock = felt.Take(attitude, X_OR, X_DO * X_OR)) rocks.push_back(*rock);
  }
  ASSERT_EQ(rocks.size(), 1u);
  EXPECT_NEAR(rocks[0].x_m, 6.2, 0.08 + 1e-3);
}

}  // namespace
}  // namespace dockyard::axel
