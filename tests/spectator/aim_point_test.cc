#include "sim/spectator/aim_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectator/some_run.h"

namespace dockyard {
namespace {

StageShapes WithPoints() {
  StageShapes shapes = SomeShapes();
  shapes.points = {{"tip", "robot", {0.5, 0.0, 0.1}}};
  shapes.bodies.push_back({.name = "shade", .parts = {}, .about = true});
  return shapes;
}

TEST(AimNames, AreTheSystemsPointsAndTheBodiesOfRobotAndTarget) {
  EXPECT_THAT(AimNames(WithPoints()), testing::ElementsAre("target", "robot", "tip"));
}

TEST(AimPlace, MovesWithTheBodyOfThePoint) {
  const LoggedRun run = SomeRun();  // the robot at x = 3 m, then at 2 m, 0.2 m up
  const StageShapes shapes = WithPoints();
  EXPECT_LT((AimPlace({"tip", {}}, run, shapes, 0) - Eigen::Vector3d(3.5, 0, 0.3)).norm(), 1e-12);
  EXPECT_LT((AimPlace({"tip", {}}, run, shapes, 1) - Eigen::Vector3d(2.5, 0, 0.3)).norm(), 1e-12);
  EXPECT_LT((AimPlace({"robot", {}}, run, shapes, 1) - Eigen::Vector3d(2, 0, 0.2)).norm(), 1e-12);
}

TEST(AimPlace, CountsAPlaceFromTheTarget) {
  LoggedRun run = SomeRun();
  run.X_WD.assign(2, FromGround(Pose2{4.0, 1.0, kPi / 2.0}, 0.0));
  const Eigen::Vector3d place =
      AimPlace({"", Eigen::Vector3d(2.0, 0.5, 0.3)}, run, WithPoints(), 0);
  EXPECT_LT((place - Eigen::Vector3d(3.5, 3.0, 0.3)).norm(), 1e-12);
}

}  // namespace
}  // namespace dockyard
