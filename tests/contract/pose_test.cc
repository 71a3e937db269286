#include "controller/geometry/pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/robot_pose.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

Pose3 RandomPose(RandomStream& random, double size) {
  return {
      ToRotation({size * random.Normal(), 0.4 * size * random.Normal(), size * random.Normal()}),
      size * Eigen::Vector3d(random.Normal(), random.Normal(), random.Normal())};
}

TEST(Pose3, InverseUndoesAtIdentityTinyAndRandom) {
  RandomStream random(1);
  for (const double size : {0.0, 1e-8, 1.0}) {
    const Pose3 X_AB = RandomPose(random, size);
    const Pose3 X_AA = X_AB * Inverse(X_AB);
    EXPECT_LT((X_AA.R - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT(X_AA.p.norm(), 1e-14);
  }
}

TEST(Pose3, ProductsCarryPointsThroughTheMiddleFrame) {
  RandomStream random(2);
  const Pose3 X_AB = RandomPose(random, 1.0), X_BC = RandomPose(random, 1.0);
  const Eigen::Vector3d p_CQ(0.3, -0.2, 1.1);
  EXPECT_LT(((X_AB * X_BC) * p_CQ - X_AB * (X_BC * p_CQ)).norm(), 1e-14);
}

TEST(Pose2, AgreesWithPose3OnTheGround) {
  const Pose2 X_AB{1.0, 2.0, 0.7}, X_BC{-0.5, 0.4, 2.9};
  const Pose2 X_AC = X_AB * X_BC;
  const Pose2 through_space = ToGround(FromGround(X_AB, 0.3) * FromGround(X_BC, -0.1));
  EXPECT_NEAR(X_AC.x, through_space.x, 1e-14);
  EXPECT_NEAR(X_AC.y, through_space.y, 1e-14);
  EXPECT_NEAR(WrapPi(X_AC.heading - through_space.heading), 0.0, 1e-14);
}

TEST(RollPitchYaw, ComeBackFromTheirRotation) {
  const RollPitchYaw rpy{0.1, -0.4, 2.5};
  const RollPitchYaw back = ToRollPitchYaw(ToRotation(rpy));
  EXPECT_NEAR(back.roll, rpy.roll, 1e-14);
  EXPECT_NEAR(back.pitch, rpy.pitch, 1e-14);
  EXPECT_NEAR(back.yaw, rpy.yaw, 1e-14);
}

TEST(RollPitchYaw, PositivePitchIsNoseDown) {
  EXPECT_LT((RotY(0.2) * Eigen::Vector3d::UnitX()).z(), 0.0);
}

TEST(DockingCoords, HeadingZeroPointsAlongTheAxisIntoTheStationWhereverTheRoverStands) {
  const Pose2 X_DR = FromDockingCoords({.r = 4.0, .alpha = Radians(30), .h = 0.0});
  EXPECT_NEAR(std::cos(X_DR.heading), -1.0, 1e-15);
  EXPECT_NEAR(X_DR.y, 2.0, 1e-12);
}

TEST(DockingCoords, AlphaEqualToHeadingPointsTheArmAtTheStation) {
  const Pose2 X_DR = FromDockingCoords({.r = 3.0, .alpha = Radians(-25), .h = Radians(-25)});
  const Eigen::Vector2d nose = X_DR * Eigen::Vector2d(3.0, 0.0);
  EXPECT_NEAR(nose.norm(), 0.0, 1e-12);
}

TEST(DockingCoords, ComeBackFromTheirPose) {
  const DockingCoords at{.r = 2.5, .alpha = -0.5, .h = 0.3};
  const DockingCoords back = ToDockingCoords(FromDockingCoords(at));
  EXPECT_NEAR(back.r, at.r, 1e-14);
  EXPECT_NEAR(back.alpha, at.alpha, 1e-14);
  EXPECT_NEAR(back.h, at.h, 1e-14);
}

TEST(WrapPi, KeepsTheHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(WrapPi(kPi), kPi);
  EXPECT_DOUBLE_EQ(WrapPi(-kPi), kPi);
  EXPECT_NEAR(WrapPi(7.0), 7.0 - 2.0 * kPi, 1e-15);
}

// A matrix rounds a heading: 0.1 rad does not come back from one.
TEST(RobotPose, KeepsTheBitsOfAPlanarPose) {
  for (const double heading : {0.1, -2.7, 3.0, 1e-9}) {
    const Pose2 X_DR{4.1, -0.3, heading};
    const RobotPose pose = X_DR;
    EXPECT_EQ(Pose2(pose), X_DR);
    EXPECT_EQ(pose.X.p, Eigen::Vector3d(4.1, -0.3, 0.0));
    EXPECT_LT((pose.X.R - RotZ(heading)).norm(), 1e-15);
  }
}

TEST(RobotPose, OfASpatialPoseHasItsPlanarView) {
  const RollPitchYaw angles{.roll = 0.2, .pitch = -0.4, .yaw = 1.1};
  const Pose3 X{ToRotation(angles), Eigen::Vector3d(1.0, 2.0, -3.0)};
  const RobotPose pose(X), same = RobotPose::FromAngles(X.p, angles);
  EXPECT_NEAR(pose.heading, 1.1, 1e-15);
  EXPECT_EQ(same.heading, 1.1);
  EXPECT_EQ(pose.x, 1.0);
  EXPECT_EQ(pose.y, 2.0);
  EXPECT_EQ(same.X.R, X.R);
}

}  // namespace
}  // namespace dockyard
