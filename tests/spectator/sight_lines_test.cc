#include "sim/spectator/sight_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectator/some_run.h"

namespace dockyard {
namespace {

bool All(const StageBody&) { return true; }
bool Robot(const StageBody& body) { return body.robot; }

// The robot is a cube of 0.4 m about (3, 0, 0.2), then about (2, 0, 0.2).
TEST(SightLines, AreBlockedByABodyWhereTheLogHasIt) {
  const LoggedRun run = SomeRun();
  const StageShapes shapes = SomeShapes();
  const SightLines lines(run, shapes);
  const Eigen::Vector3d left(2.1, 1.0, 0.1), right(2.1, -1.0, 0.3);
  EXPECT_FALSE(lines.Blocked(left, right, 0, All));
  EXPECT_TRUE(lines.Blocked(left, right, 1, All));
  EXPECT_TRUE(lines.Blocked(right, left, 1, Robot));
  // It ends before the cube, whose side is at y = 0.2, or within it; over it; of another body.
  EXPECT_FALSE(lines.Blocked(left, {2.1, 0.21, 0.2}, 1, All));
  EXPECT_TRUE(lines.Blocked(left, {2.1, 0.19, 0.2}, 1, All));
  EXPECT_FALSE(lines.Blocked({2.1, 1.0, 0.41}, {2.1, -1.0, 0.41}, 1, All));
  EXPECT_FALSE(lines.Blocked(left, right, 1, [](const StageBody& body) { return !body.robot; }));
}

TEST(SightLines, HaveTheDistanceFromATurnedBody) {
  LoggedRun run = SomeRun();
  run.X_WO[0][1].R = RotZ(kPi / 4.0);
  const StageShapes shapes = SomeShapes();
  const SightLines lines(run, shapes);
  EXPECT_NEAR(lines.RobotDistance_m({3.0, 1.0, 0.2}, 0), 0.8, 1e-6);
  EXPECT_NEAR(lines.RobotDistance_m({2.0, 1.0, 0.2}, 1), 1.0 - 0.2 * std::sqrt(2.0), 1e-6);
  EXPECT_EQ(lines.RobotDistance_m({2.0, 0.0, 0.2}, 1), 0.0);
}

TEST(SightLines, HaveTheReachAndTheCornersOfWhatIsDrawn) {
  const LoggedRun run = SomeRun();
  const StageShapes shapes = SomeShapes();
  const SightLines lines(run, shapes);
  // The target's cube of 0.2 m has its origin in its lower face.
  EXPECT_NEAR(lines.Reach_m("target"), std::sqrt(0.01 + 0.01 + 0.04), 1e-6);
  EXPECT_EQ(lines.Reach_m("kiosk"), 0.0);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& corner : lines.RobotCorners_W(1)) box.extend(corner);
  EXPECT_LT((box.min() - Eigen::Vector3d(1.8, -0.2, 0.0)).norm(), 1e-6);
  EXPECT_LT((box.max() - Eigen::Vector3d(2.2, 0.2, 0.4)).norm(), 1e-6);
}

TEST(SightLines, RefuseALogOfOtherBodies) {
  const LoggedRun run = SomeRun();
  StageShapes shapes = SomeShapes();
  shapes.bodies[1].name = "kiosk";
  EXPECT_THROW(SightLines(run, shapes), DataError);
}

}  // namespace
}  // namespace dockyard
