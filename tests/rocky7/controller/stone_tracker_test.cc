#include "controller/rocky7/stone_tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/random.h"
#include "tracking/height_scene.h"

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector2d;

const Eigen::Vector3d kCameras_E(0.0, 0.0, 0.3);

// What a rover at X_WE sees of a scene; the cameras stand above its origin.
GroundMaps Maps(const HeightScene& scene, const Pose2& X_WE, double sigma_m, std::uint64_t seed) {
  RandomStream random(seed);
  GroundMaps maps;
  maps.fine = maps.closed = scene.Map(X_WE, sigma_m, random);
  maps.p_EC = kCameras_E;
  return maps;
}

// A click on what is at a place and a height; the range data there may be of something else.
Clicked ClickOn(const Vector2d& p_E, double height_m, const Vector2d& range_off_m = {0, 0}) {
  const Eigen::Vector3d ray = Eigen::Vector3d(p_E.x(), p_E.y(), height_m) - kCameras_E;
  return {p_E + range_off_m, ray.normalized(), 0.006};
}

Predicted From(const Pose2& X_WE, const Vector2d& p_W, const Pose2& X_WE_before,
               const Vector2d& off_m) {
  const Vector2d p_E = Inverse(X_WE) * p_W + off_m;
  return {{p_E.x(), p_E.y(), X_WE_before.heading - X_WE.heading},
          Vector2d(4e-4, 1e-4).asDiagonal()};
}

TEST(StoneTracker, TakesTheStoneOnTheClicksRayNotTheOneNearTheRangeData) {
  const HeightScene scene{{{{0.9, 0.0}, 0.02, 0.02}, {{0.82, 0.06}, 0.02, 0.02}}};
  StoneTracker tracker;
  const TargetSighting seen =
      tracker.Begin(Maps(scene, {}, 1e-3, 1), ClickOn({0.9, 0.0}, 0.01, {-0.08, 0.05}));
  ASSERT_TRUE(seen.found);
  EXPECT_LT((seen.p_E - scene.stones[0].p).norm(), 0.005);
}

// The ground ahead rises by 6 cm, and the map has no cell where the user clicked. With the ground
// at 0 the click's ray would meet it 18 cm behind the stone.
TEST(StoneTracker, TakesTheStoneOnTheRayWhereTheGroundRises) {
  HeightScene scene{{{{0.9, 0.0}, 0.02, 0.02}, {{0.82, 0.2}, 0.02, 0.02}}};
  scene.slope_x = 0.06 / 0.9;
  GroundMaps maps = Maps(scene, {}, 1e-3, 1);
  for (float& height_m : maps.closed.height_m) height_m = std::nanf("");
  StoneTracker tracker;
  const TargetSighting first = tracker.Begin(maps, ClickOn({0.9, 0.0}, 0.07));
  ASSERT_TRUE(first.found) << first.why;
  EXPECT_EQ(first.why, "");
  EXPECT_LT((first.p_E - scene.stones[0].p).norm(), 0.005);
}

// The same stones from nearer by and turned, while odometry is off by the way to the neighbour.
TEST(StoneTracker, KeepsItsStoneWhereOdometryPointsAtTheNeighbour) {
  const HeightScene scene{
      {{{1.0, 0.0}, 0.02, 0.02}, {{1.06, 0.01}, 0.02, 0.02}, {{0.92, 0.1}, 0.02, 0.025}}};
  StoneTracker tracker;
  ASSERT_TRUE(tracker.Begin(Maps(scene, {}, 1e-3, 2), ClickOn({1.0, 0.0}, 0.01)).found);
  const Pose2 X_WE{0.3, 0.02, 0.1};
  const TargetSighting seen =
      tracker.Follow(Maps(scene, X_WE, 1e-3, 3), From(X_WE, {1.0, 0.0}, {}, {0.06, 0.01}));
  ASSERT_TRUE(seen.found) << seen.why;
  EXPECT_LT((X_WE * seen.p_E - scene.stones[0].p).norm(), 0.005);
}

TEST(StoneTracker, SaysThatItsStoneIsGoneThoughANeighbourStandsThere) {
  HeightScene scene{
      {{{0.6, 0.0}, 0.02, 0.02}, {{0.66, 0.01}, 0.02, 0.02}, {{0.52, 0.1}, 0.02, 0.025}}};
  StoneTracker tracker;
  ASSERT_TRUE(tracker.Begin(Maps(scene, {}, 1e-3, 4), ClickOn({0.6, 0.0}, 0.01)).found);
  scene.stones.erase(scene.stones.begin());
  const Pose2 X_WE{0.1, 0.0, 0.0};
  const TargetSighting seen =
      tracker.Follow(Maps(scene, X_WE, 1e-3, 5), From(X_WE, {0.6, 0.0}, {}, {0.01, 0.0}));
  EXPECT_FALSE(seen.found);
  EXPECT_TRUE(seen.gone);
}

// A neighbour 4 cm aside, lower than the target by a fifth, is what is left in the inspected
// window.
TEST(StoneTracker, DoesNotTakeANeighbourForAStoneThatTheScoopsHaveLifted) {
  HeightScene scene{{{{0.6, 0.0}, 0.02, 0.02}, {{0.6, -0.045}, 0.015, 0.016}}};
  StoneTracker tracker;
  ASSERT_TRUE(tracker.Begin(Maps(scene, {}, 1e-3, 8), ClickOn({0.6, 0.0}, 0.01)).found);
  EXPECT_TRUE(tracker.Check(Maps(scene, {}, 1e-3, 9), {0.6, 0.0, 0.0}).found);
  scene.stones.erase(scene.stones.begin());
  const TargetSighting after = tracker.Check(Maps(scene, {}, 1e-3, 10), {0.6, 0.0, 0.0});
  EXPECT_FALSE(after.found);
  EXPECT_TRUE(after.gone);
}

// The rover's wheels turned on the spot: all stones are further ahead than odometry has them.
TEST(StoneTracker, FindsItsStoneThoughTheRoverStoodStill) {
  const HeightScene scene{{{{0.8, 0.0}, 0.02, 0.02}}};
  StoneTracker tracker;
  ASSERT_TRUE(tracker.Begin(Maps(scene, {}, 1e-3, 6), ClickOn({0.8, 0.0}, 0.01)).found);
  Predicted target = From({}, {0.8, 0.0}, {}, {-0.1, 0.0});
  target.way_m = 0.11;
  const TargetSighting seen = tracker.Follow(Maps(scene, {}, 1e-3, 7), target);
  ASSERT_TRUE(seen.found) << seen.why;
  EXPECT_LT((seen.p_E - scene.stones[0].p).norm(), 0.004);
}

}  // namespace
}  // namespace dockyard::rocky7
