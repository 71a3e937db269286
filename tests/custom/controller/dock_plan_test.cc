#include "controller/custom/dock_plan.h"

#include <gtest/gtest.h>

#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

DockPlan PlanOf(const TestRobot& robot) {
  const Nominal nominal = NominalOf(robot);
  const auto plan = PlanDocking(nominal, *FindDrive(nominal));
  EXPECT_TRUE(plan);
  return *plan;
}

TEST(DockPlan, DrivesForwardWithACameraAhead) {
  const DockPlan plan = PlanOf({});
  EXPECT_DOUBLE_EQ(plan.travel, 1.0);
  EXPECT_FALSE(plan.drives_blind);
  EXPECT_EQ(plan.cameras, std::vector<int>{0});
  EXPECT_NEAR(plan.X_DA_docked.x, 0.25, 1e-12);
  EXPECT_NEAR(plan.X_DA_staging.x, 0.95, 1e-12);
  EXPECT_NEAR(plan.Left(plan.X_DA_staging), 0.7, 1e-12);
  EXPECT_NEAR(plan.Aside({0.5, 0.1, kPi}), -0.1, 1e-12);  // the path runs along -x, its left is -y
}

TEST(DockPlan, ShiftsTheDockedPoseToTheLeftOfThePath) {
  for (const bool backward : {false, true}) {
    TestRobot robot;
    robot.docks_backward = robot.rear_camera = backward;
    DockPlan plan = PlanOf(robot);
    const Pose2 docked = plan.X_DA_docked;
    EXPECT_NEAR(plan.OffDocked(docked).y, 0.0, 1e-12);
    plan.Shift(0.005);
    EXPECT_NEAR(plan.Aside(docked), -0.005, 1e-12);  // it lies to the right of the new one
    EXPECT_NEAR(plan.X_DA_docked.y, -0.005, 1e-12);  // the path runs along -x
  }
}

TEST(DockPlan, PlacesTheMiddleOfTheAxleNotTheRobotsOrigin) {
  TestRobot robot;
  robot.axle_x_m = 0.1;
  EXPECT_NEAR(PlanOf(robot).X_DA_docked.x, 0.15, 1e-12);
}

TEST(DockPlan, BackwardNeedsATurnUnlessACameraIsAtTheRear) {
  TestRobot robot;
  robot.docks_backward = true;
  const DockPlan blind = PlanOf(robot);
  EXPECT_DOUBLE_EQ(blind.travel, -1.0);
  EXPECT_TRUE(blind.drives_blind);
  EXPECT_NEAR(std::abs(blind.measuring_rad), kPi, 1e-9);
  EXPECT_NEAR(blind.X_DA_docked.heading, 0.0, 1e-9);
  EXPECT_NEAR(blind.Left(blind.X_DA_staging), 0.7, 1e-12);
  EXPECT_NEAR(blind.Aside({0.5, 0.1, 0.0}), -0.1, 1e-12);
  robot.rear_camera = true;
  EXPECT_FALSE(PlanOf(robot).drives_blind);
}

TEST(DockPlan, TurnsACameraAtTheSideToTheDock) {
  Nominal nominal = NominalOf();
  nominal.cameras[0].X_RC = CameraAt({0.0, 0.1, 0.25}, 0.5 * kPi);
  const auto plan = PlanDocking(nominal, *FindDrive(nominal));
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan->drives_blind);
  EXPECT_NEAR(WrapPi(plan->measuring_rad - 0.5 * kPi), 0.0, 1e-9);
}

TEST(DockPlan, IsRefusedForADockedHeadingAcrossAndForAHiddenBoard) {
  Nominal across = NominalOf();
  across.X_DQ.R = RotZ(0.5 * kPi);
  EXPECT_FALSE(PlanDocking(across, *FindDrive(across)));
  Nominal hidden = NominalOf();
  hidden.boards[0].X_DB.R = RotZ(kPi) * hidden.boards[0].X_DB.R;
  EXPECT_FALSE(PlanDocking(hidden, *FindDrive(hidden)));
}

}  // namespace
}  // namespace dockyard::custom
