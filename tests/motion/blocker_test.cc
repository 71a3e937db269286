#include "controller/motion/blocker.h"

#include <gtest/gtest.h>

#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kMargin_m = 0.02;

struct Scene {
  std::vector<Arc> path;
  Obstacles obstacles;
};

// Two arcs, a disc and a wall.
Scene AnyScene(RandomStream& random) {
  Scene scene{{{random.Uniform(-1, 1.5), random.Uniform(-1.5, 1.5)},
               {random.Uniform(-1, 1.5), random.Uniform(-1.5, 1.5)}},
              {}};
  const Vector2d at(random.Uniform(-1, 3), random.Uniform(-1.5, 1.5));
  if (random.Uniform(0, 1) < 0.5) {
    scene.obstacles.discs = {{at, random.Uniform(0.02, 0.2)}};
  } else {
    scene.obstacles.polygons = {
        {at, at + Vector2d(0.5, 0.1), at + Vector2d(0.4, 0.3), at + Vector2d(0.0, 0.2)}};
  }
  return scene;
}

TEST(Cover, FindsABlockerOnMostBlockedPathsAndOnNoFreeOne) {
  RandomStream random(StreamKey(1, "blockers"));
  const RoverPlan rover = RockySample();
  const Cover cover(rover);
  int blocked = 0, found = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = AnyScene(random);
    const bool is_free = Clearance(rover, scene.path, scene.obstacles, kMargin_m) == kMargin_m;
    const auto blocker =
        cover.Find(scene.path, DiscsWithin(scene.obstacles, kMargin_m), i % 2 == 0 ? 0 : 16);
    if (is_free) {
      EXPECT_FALSE(blocker);
      continue;
    }
    ++blocked;
    if (blocker) ++found;
  }
  EXPECT_GT(blocked, 300);
  EXPECT_LT(blocked, 2700);
  EXPECT_GT(found, blocked * 0.9);
}

// What lets a search leave out the paths near a blocked one.
TEST(Cover, StaysBlockedWhereItIsMovedByLessThanTheOverlap) {
  RandomStream random(StreamKey(2, "overlap"));
  const RoverPlan rover = RockySample();
  const Cover cover(rover);
  int wheels = 0, bodies = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = AnyScene(random);
    const auto blocker = cover.Find(scene.path, DiscsWithin(scene.obstacles, kMargin_m), 0);
    if (!blocker) continue;
    ++(blocker->wheel ? wheels : bodies);
    const Pose2 X_AP = cover.PoseOf(*blocker, scene.path);
    const double overlap_m = cover.Overlap(*blocker, X_AP);
    const double share = random.Uniform(0, 1), angle = random.Uniform(-kPi, kPi);
    const double way_m = 0.999 * share * overlap_m;
    const double turn = 0.999 * (1.0 - share) * overlap_m / cover.Reach(*blocker);
    const Pose2 moved = Pose2{way_m * std::cos(angle), way_m * std::sin(angle), 0.0} * X_AP *
                        Pose2{0.0, 0.0, i % 2 == 0 ? turn : -turn};
    EXPECT_GT(cover.Overlap(*blocker, moved), 0.0);
  }
  EXPECT_GT(wheels, 20);
  EXPECT_GT(bodies, 300);
}

}  // namespace
}  // namespace dockyard
