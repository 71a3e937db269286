#include "sim/rocky7/placeable_rock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "models/read/config_error.h"
#include "rocky7/sim/test_scenario.h"
#include "sim/base/random.h"
#include "sim/rigid/slope.h"
#include "sim/rocky7/build_run.h"
#include "sim/rocky7/user_click.h"
#include "sim/rocky7/world.h"

namespace dockyard::rocky7 {
namespace {

using testing::HasSubstr;

RoverModel Rover() { return LoadModels(OnGravel("{task: place}", 5.0, 9.0)).nominal.robot.rover; }

StarBody Ball(const Eigen::Vector3d& middle, double radius_m) {
  return MakeStarBody(middle, 6, [=](const Eigen::Vector3d&) { return radius_m; });
}

Eigen::Vector3d Up(double up_deg) {
  return {-std::cos(Radians(up_deg)), 0.0, std::sin(Radians(up_deg))};
}

TEST(PlaceableRock, ABallFallsAwayUnderTheSwitchesByItsSagitta) {
  const InstrumentModel instrument = Rover().mast->instrument;
  for (const double radius_m : {0.08, 0.12, 0.3}) {
    const StarBody ball = Ball({0.0, 0.0, 0.2}, radius_m);
    const Eigen::Vector3d normal = Up(30.0);
    const auto fall_m = FallUnderSwitches(
        ball, instrument, Eigen::Vector3d(0.0, 0.0, 0.2) + radius_m * normal, normal);
    ASSERT_TRUE(fall_m);
    const double r = instrument.switch_radius_m;
    EXPECT_NEAR(*fall_m, radius_m - std::sqrt(radius_m * radius_m - r * r), 1.5e-4) << radius_m;
  }
}

// With both links of 0.5 m the tool meets a height over the shoulder of
// 0.5 (sin(first) - sin(normal's elevation)). Lowest: the first link is level, or the elbow bent by
// 20 deg, with the rover pitched down by 2.5 deg 0.8 m before the target, which then is as low.
TEST(PlaceableRock, TheMastMeetsNoLowPointWhoseNormalIsLevel) {
  const RoverModel rover = Rover();
  const double shoulder_m = rover.mast->p_RM.z() + RollingRadius(rover.tyre);
  const auto meets = [&](double up_m, double up_deg) {
    const Eigen::Vector3d target(0.0, 0.0, up_m), normal = Up(up_deg);
    return MastMeets(Ball(target - 0.1 * normal, 0.1), rover, target, normal);
  };
  for (const double up_deg : {22.0, 30.0, 40.0}) {
    const double pitched_deg = up_deg - 2.5;
    const double first_rad = std::max(0.0, Radians(20.0 - pitched_deg));
    const double lowest_m = shoulder_m +
                            0.5 * (std::sin(first_rad) - std::sin(Radians(pitched_deg))) +
                            0.8 * std::sin(Radians(2.5));
    EXPECT_TRUE(meets(lowest_m + 0.005, up_deg)) << up_deg;
    EXPECT_FALSE(meets(lowest_m - 0.005, up_deg)) << up_deg;
  }
  EXPECT_FALSE(meets(0.25, 0.0));
}

// Both links are about 45 deg over or under level: 0.7 m from the mast's axis. The wheels' front is
// 0.42 m before that and keeps 5 cm off: 0.2 m are left for the foot.
TEST(PlaceableRock, ThePointIsOutOfReachBehindALongFoot) {
  const RoverModel rover = Rover();
  const Eigen::Vector3d target(0.0, 0.0, 0.35), normal = Up(45.0);
  const auto meets = [&](double radius_m) {
    return MastMeets(Ball(target - radius_m * normal, radius_m), rover, target, normal);
  };
  EXPECT_TRUE(meets(0.1));
  EXPECT_FALSE(meets(1.2));
}

TEST(PlaceableRock, IsTheFirstOfItsKeyThatIsPlaceable) {
  const RoverModel rover = Rover();
  const RoundedRockShape shape{.target_up_m = 0.3, .face_up_rad = Radians(35.0)};
  const Eigen::Vector3d target(0.0, 0.0, 0.3);
  const Eigen::Vector3d along(std::cos(Radians(35.0)), 0.0, std::sin(Radians(35.0)));
  const auto first = [&](std::uint64_t key) {
    return FirstRock(shape, key,
                     [&](const StarBody& rock) { return IsPlaceable(rock, shape, rover); });
  };
  int drawn_again = 0;
  for (std::uint64_t key = 1; key <= 6; ++key) {
    const auto rock = first(key);
    ASSERT_TRUE(rock);
    const auto normal = NormalUnderDisc(*rock, target, along, rover.mast->instrument.radius_m);
    ASSERT_TRUE(normal);
    EXPECT_TRUE(MastMeets(*rock, rover, target, *normal));
    const auto fall_m = FallUnderSwitches(*rock, rover.mast->instrument, target, *normal);
    ASSERT_TRUE(fall_m);
    EXPECT_LE(std::abs(*fall_m), rover.mast->instrument.switch_out_m);
    EXPECT_EQ(first(key)->vertices, rock->vertices);
    drawn_again += rock->vertices != MakeRoundedRock(shape, key).vertices;
  }
  EXPECT_GE(drawn_again, 1);  // one in two does not do
}

// From the centre of a ball of 0.2 m a camera at distance d is d away; the ball's point at angle a
// from the line to the camera is in view while cos a > 0.2 / d.
TEST(PlaceableRock, ABallShowsThePointsOfItsNearSide) {
  const double radius_m = 0.2, away_m = 6.0;
  const Eigen::Vector3d target(0.0, 0.0, 0.25);
  const RoundedRockShape shape{.target_up_m = target.z()};
  const double horizon_deg = Degrees(std::acos(radius_m / away_m));
  for (const double off_deg : {0.0, 60.0, -6.0 + horizon_deg, 6.0 + horizon_deg, 180.0}) {
    const Eigen::Vector3d normal = Up(40.0 + off_deg);
    const Eigen::Vector3d middle = target - radius_m * normal;
    EXPECT_EQ(ShowsTarget(Ball(middle, radius_m), shape, middle + away_m * Up(40.0)),
              off_deg < horizon_deg)
        << off_deg;
  }
}

// Springs yield, the mast hangs by its weight, and wheels sink in.
TEST(PlaceableRock, TheMastCameraAtTheStartIsWhereTheWorldHasIt) {
  const Scenario scenario = OnGravel("{task: place}", 5.0, 9.0);
  const Rocky7Models models = LoadModels(scenario);
  const BuiltRun run = BuildRun(scenario, models);
  const Truth truth = World(run.world).truth();
  const Eigen::Vector3d p_WC = truth.X_WK * run.mast_pair.X_RL.p;
  const Pose3 X_WG = SiteInWorld(run.world.X_WG, run.world.slope);
  EXPECT_LT((X_WG * MastCameraAtStart(models.nominal.robot, run.world.X_GR_start) - p_WC).norm(),
            0.03);
}

// Runs 5 and 9 of the paper's campaign had their summits behind another part of the rock.
TEST(PlaceableRock, AScenarioHasARockWhoseSummitIsInView) {
  Scenario scenario = OnGravel("{task: place, boulder: rounded, face_up_deg: 90}", 5.0, 9.0);
  int drawn_again = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    scenario.seed = seed;
    const Rocky7Models models = LoadModels(scenario);
    const BuiltRun run = BuildRun(scenario, models);
    EXPECT_NO_THROW(ClickOn(scenario, run, World(run.world).truth())) << seed;
    const RoundedRockShape shape{.width_m = models.keys.boulder_m,
                                 .target_up_m = models.keys.target_up_m,
                                 .face_up_rad = models.keys.face_up_rad,
                                 .face_turn_rad = models.keys.face_turn_rad,
                                 .roughness_m = models.keys.roughness_m};
    const StarBody first = MakeRoundedRock(shape, StreamKey(scenario.seed, "target"));
    drawn_again += run.world.boulder->vertices != first.vertices;
  }
  EXPECT_GE(drawn_again, 1);
}

TEST(PlaceableRock, AScenarioWithoutOneIsRefused) {
  const Scenario scenario = OnGravel(
      "{task: place, boulder: rounded, placeable: true, face_up_deg: 0, target_up_m: 0.15}", 5.0,
      9.0);
  try {
    BuildRun(scenario, LoadModels(scenario));
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("on which the mast can place its instrument"));
    EXPECT_THAT(error.what(), HasSubstr("rocky7.face_up_deg 0"));
  }
}

TEST(PlaceableRock, IsAKeyOfRoundedRocksAlone) {
  EXPECT_THROW(ReadRocky7Keys(OnGravel("{task: place, placeable: true}", 5.0, 9.0)), ConfigError);
}

}  // namespace
}  // namespace dockyard::rocky7
