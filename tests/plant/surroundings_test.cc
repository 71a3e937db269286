// Rooms and outdoor scenes: walls at their places, things clear of the robot's paths.
#include "sim/plant/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

using Kind = SceneryItem::Kind;

const SceneryItem kRoom{.kind = Kind::kRoom,
                        .size_m = {7.0, 6.0, 0.0},
                        .X_DO = {0.8, 0.0, 0.0},
                        .count = 30,
                        .clear_m = 0.8};
const SceneryItem kOutdoors{
    .kind = Kind::kOutdoors, .X_DO = {0.8, 0.0, 0.0}, .count = 60, .radius_m = 6.0, .clear_m = 0.8};
const Eigen::Vector2d kStart(1.5, 1.8);

/// Of a turned box or of a round solid, its nearest point to p in plan.
double GapTo(const SceneryItem& solid, const Eigen::Vector2d& p) {
  const Eigen::Vector2d p_O = Inverse(solid.X_DO) * p;
  if (solid.kind != Kind::kBox) return p_O.norm() - 0.5 * solid.size_m.x();
  const Eigen::Vector2d beyond = p_O.cwiseAbs() - 0.5 * solid.size_m.head<2>();
  return beyond.cwiseMax(0.0).norm();
}

/// Not lying on the floor as its joints do, nor flat as leaves.
bool IsHigh(const SceneryItem& solid) { return solid.size_m.z() > 0.02 && solid.up_m <= 0.0; }

void ExpectClear(const std::vector<SceneryItem>& solids, std::uint64_t seed) {
  for (const SceneryItem& solid : solids) {
    if (!IsHigh(solid)) continue;
    for (double s = 0.0; s <= 1.0; s += 0.02) {
      ASSERT_GE(GapTo(solid, s * kStart), 0.79) << seed;
      ASSERT_GE(GapTo(solid, {s, 0.0}), 0.79) << seed;
    }
  }
}

TEST(Surroundings, LeaveTheRobotItsPaths) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    ExpectClear(DrawRoom(kRoom, kStart, seed), seed);
    ExpectClear(DrawOutdoors(kOutdoors, kStart, seed), seed);
  }
}

TEST(Surroundings, ARoomIsClosedByItsWallsAndNothingIsBeyondThem) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto solids = DrawRoom(kRoom, kStart, seed);
    // From the middle every bearing ends at a wall of 2.7 m.
    for (double bearing = -kPi; bearing < kPi; bearing += 0.05) {
      const bool meets = std::ranges::any_of(solids, [&](const SceneryItem& solid) {
        if (solid.size_m.z() < 2.6) return false;
        for (double r_m = 2.5; r_m < 5.0; r_m += 0.02) {
          const Eigen::Vector2d p(0.8 + r_m * std::cos(bearing), r_m * std::sin(bearing));
          if (GapTo(solid, p) <= 0.0) return true;
        }
        return false;
      });
      EXPECT_TRUE(meets) << seed << ' ' << bearing;
    }
    for (const SceneryItem& solid : solids) {
      EXPECT_LE(std::abs(solid.X_DO.x - 0.8), 3.5 + 0.06);
      EXPECT_LE(std::abs(solid.X_DO.y), 3.0 + 0.06);
    }
  }
}

TEST(Surroundings, OfARoomHaveTheirColoursAndReddishThingsTheirSize) {
  using enum SceneryItem::Colour;
  SceneryItem room = kRoom;
  const auto count = [&](SceneryItem::Colour colour) {
    int n = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      for (const SceneryItem& solid : DrawRoom(room, kStart, seed)) n += solid.colour == colour;
    }
    return n;
  };
  room.reddish_m = 2.5;
  EXPECT_EQ(count(kDenim) + count(kBrick) + count(kConeOrange), 0);
  room.coloured = 0.5;
  EXPECT_GT(count(kDenim), 50);
  EXPECT_GT(count(kBrick), 50);
  EXPECT_GT(count(kConeOrange), 30);
  room.reddish_m = 0.05;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const SceneryItem& solid : DrawRoom(room, kStart, seed)) {
      if (solid.colour != kBrick && solid.colour != kConeOrange) continue;
      EXPECT_LE(solid.size_m.maxCoeff(), 0.05 + 1e-12);
    }
  }
}

TEST(Surroundings, FollowFromTheSeed) {
  const auto a = DrawRoom(kRoom, kStart, 1), b = DrawRoom(kRoom, kStart, 1),
             c = DrawRoom(kRoom, kStart, 2);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].X_DO, b[i].X_DO);
  EXPECT_FALSE(std::ranges::equal(a, c, {}, &SceneryItem::X_DO, &SceneryItem::X_DO));
}

}  // namespace
}  // namespace dockyard
