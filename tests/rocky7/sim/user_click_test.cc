#include "sim/rocky7/user_click.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/read/config_error.h"
#include "rocky7/sim/test_scenario.h"
#include "sim/rigid/slope.h"
#include "sim/vehicles/boulder.h"

namespace dockyard::rocky7 {
namespace {

struct Clicked {
  BuiltRun run;
  Truth truth;
  UserClick click;
};

Clicked ClickFrom(double from_m, const std::string& task, std::uint64_t seed) {
  Scenario scenario = OnGravel(task, from_m, from_m + 3.0);
  scenario.seed = seed;
  BuiltRun run = BuildRun(scenario, LoadModels(scenario));
  const Truth truth = World(run.world).truth();
  return {run, truth, ClickOn(scenario, run, truth)};
}

// From 4 m with a hand of 12 px, 6 cm across the view, many clicks fall beyond an edge 3 cm away.
TEST(UserClick, OnABoulderTheTargetIsWhatTheClickShowsAndLiesOnTheFaceThatIsMeant) {
  double farthest_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Clicked at = ClickFrom(
        4.0, "{task: place, target_up_m: 0.18, face_up_deg: 60, rim_m: 0.03, click_px: 12}", seed);
    const Pose3 X_GC = Inverse(SiteInWorld(at.run.world.X_WG, at.run.world.slope)) * at.truth.X_WK *
                       at.run.mast_pair.X_RL;
    const auto pixel = at.run.mast_pair.left.Project(Inverse(X_GC) * at.click.target_G);
    ASSERT_TRUE(pixel.has_value());
    EXPECT_LT((*pixel - at.click.pixel).norm(), 1e-6) << seed;
    const Eigen::Vector3d normal = FaceNormal({.face_up_rad = Radians(60.0), .face_turn_rad = 0.0});
    const Eigen::Vector3d from_middle = at.click.target_G - Eigen::Vector3d(0.0, 0.0, 0.18);
    EXPECT_LT(std::abs(normal.dot(from_middle)), 3.1e-3) << seed;
    farthest_m = std::max(farthest_m, from_middle.norm());
  }
  EXPECT_GT(farthest_m, 0.02);
}

TEST(UserClick, AStoneStaysTheTargetWhereverTheClickFalls) {
  const Clicked at = ClickFrom(1.5, "{task: grasp, click_px: 4}", 1);
  EXPECT_EQ(at.click.target_G, at.truth.X_GT.p);
  const auto middle = at.run.front.left.Project(
      Inverse(Inverse(SiteInWorld(at.run.world.X_WG, at.run.world.slope)) * at.truth.X_WR *
              at.run.front.X_RL) *
      at.truth.X_GT.p);
  EXPECT_GT((at.click.pixel - *middle).norm(), 0.1);
}

// A block of 3 cm, 10 cm before a stone, from below the ground to a height over the line of sight
// to the stone's middle.
void PutBlockBefore(Clicked& at, const Pose3& X_GC, double above_ray_m) {
  const Eigen::Vector3d middle = at.truth.X_GT.p;
  const Eigen::Vector3d at_G = middle + 0.1 * (X_GC.p - middle).normalized();
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.015, 0.015}) {
    for (const double y : {-0.05, 0.05}) {
      for (const double z : {-0.1, above_ray_m}) corners.push_back(at_G + Eigen::Vector3d(x, y, z));
    }
  }
  at.run.world.stones.push_back(HullOf(corners));
}

// The stone is 3 cm high: a block that ends 3 mm above the ray to its middle leaves its top to be
// clicked on, with a hand that shakes by 6 px. One that ends 6 cm above it hides the stone.
TEST(UserClick, NeverMeansAnotherStoneThanTheTarget) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Clicked at = ClickFrom(1.5, "{task: grasp, click_px: 6}", seed);
    const Pose3 X_GC = Inverse(SiteInWorld(at.run.world.X_WG, at.run.world.slope)) * at.truth.X_WR *
                       at.run.front.X_RL;
    Scenario scenario = OnGravel("{task: grasp, click_px: 6}", 1.5, 4.5);
    scenario.seed = seed;
    PutBlockBefore(at, X_GC, 0.003);
    const UserClick click = ClickOn(scenario, at.run, at.truth);
    const Eigen::Vector3d along = X_GC.R * at.run.front.left.Direction(click.pixel);
    EXPECT_FALSE(RayEnters(at.run.world.stones.back(), X_GC.p, along)) << seed;
    EXPECT_EQ(click.target_G, at.truth.X_GT.p);
    PutBlockBefore(at, X_GC, 0.06);
    EXPECT_THROW(ClickOn(scenario, at.run, at.truth), ConfigError) << seed;
  }
}

}  // namespace
}  // namespace dockyard::rocky7
