#include "controller/custom/level_pose.h"

#include <gtest/gtest.h>

#include <cmath>

#include "custom/controller/test_robot.h"
#include "sim/base/random.h"

namespace dockyard::custom {
namespace {

PoseBranch BranchAt(const Pose3& X_DR, const Nominal& nominal) {
  PoseBranch branch;
  branch.X_CB = Inverse(X_DR * nominal.cameras[0].X_RC) * nominal.boards[0].X_DB;
  Eigen::Matrix<double, 6, 1> sigma;
  sigma << 0.004, 0.004, 0.02, 0.03, 0.03, 0.01;
  branch.covariance.diagonal() = sigma.cwiseAbs2();
  return branch;
}

TEST(PlaceDock, GivesTheDockInTheRobotOnTiltedGroundToo) {
  const Nominal nominal = NominalOf();
  const Pose2 X_DR{1.2, -0.3, 2.8};
  const ImuSample imu{.roll_rad = 0.05, .pitch_rad = -0.08};
  const Pose3 tilted = FromGround(X_DR, 0.0) *
                       Pose3{RotY(imu.pitch_rad) * RotX(imu.roll_rad), Eigen::Vector3d::Zero()};
  const PlacedDock dock = PlaceDock(BranchAt(tilted, nominal), nominal.cameras[0].X_RC,
                                    nominal.boards[0].X_DB, nominal.height_m, imu);
  const Pose2 X_RD = Inverse(X_DR);
  EXPECT_NEAR(dock.X_HD.x, X_RD.x, 1e-9);
  EXPECT_NEAR(dock.X_HD.y, X_RD.y, 1e-9);
  EXPECT_NEAR(dock.X_HD.heading, X_RD.heading, 1e-9);
  EXPECT_NEAR(dock.floor_misfit, 0.0, 1e-9);
}

TEST(PlaceDock, RefusesByTheFloorADockThatIsTilted) {
  const Nominal nominal = NominalOf();
  PoseBranch branch = BranchAt(FromGround({1.2, 0.0, kPi}, 0.0), nominal);
  branch.X_CB.R = RotX(Radians(20.0)) * branch.X_CB.R;
  const PlacedDock dock =
      PlaceDock(branch, nominal.cameras[0].X_RC, nominal.boards[0].X_DB, nominal.height_m, {});
  EXPECT_GT(dock.floor_misfit, 16.3);
}

TEST(PlaceDock, RulesOutTheMirroredBranchWhereTheCameraIsHigherThanTheBoard) {
  Nominal nominal = NominalOf();
  nominal.cameras[0].X_RC = CameraAt({0.15, 0.0, 1.0}, 0.0);
  nominal.cameras[0].X_RC.R = RotY(Radians(30.0)) * nominal.cameras[0].X_RC.R;
  PoseBranch branch = BranchAt(FromGround({1.2, 0.0, kPi}, 0.0), nominal);
  const auto misfit = [&] {
    return PlaceDock(branch, nominal.cameras[0].X_RC, nominal.boards[0].X_DB, 0.0, {}).floor_misfit;
  };
  EXPECT_LT(misfit(), 1e-6);
  branch.X_CB = Mirrored(branch.X_CB);
  EXPECT_GT(misfit(), 16.3);
}

TEST(PlaceDock, ErrsAsItsCovarianceSays) {
  // Mean of the normalised squared errors of 3 degrees of freedom: 3, 1 sigma sqrt(6 / n).
  const Nominal nominal = NominalOf();
  const FloorSpread exact{.height_m = 1e-3,
                          .tilt_rad = 1e-3,
                          .range_share = 0.0,
                          .aside_rad = 0.0,
                          .place_m = 0.0,
                          .heading_rad = 0.0};
  RandomStream random(3);
  const Pose2 X_DR{1.5, 0.5, -2.6};
  double sum = 0.0;
  const int count = 2000;
  for (int i = 0; i < count; ++i) {
    PoseBranch branch = BranchAt(FromGround(X_DR, 1e-3 * random.Normal()), nominal);
    Eigen::Matrix<double, 6, 1> error;
    for (int k = 0; k < 6; ++k) error(k) = std::sqrt(branch.covariance(k, k)) * random.Normal();
    branch.X_CB = {TurnAbout(error.tail<3>()) * branch.X_CB.R, branch.X_CB.p + error.head<3>()};
    const PlacedDock dock =
        PlaceDock(branch, nominal.cameras[0].X_RC, nominal.boards[0].X_DB, 0.0, {}, exact);
    const Pose2 X_RD = Inverse(X_DR);
    const Eigen::Vector3d off(dock.X_HD.x - X_RD.x, dock.X_HD.y - X_RD.y,
                              WrapPi(dock.X_HD.heading - X_RD.heading));
    sum += off.dot(dock.covariance.inverse() * off);
  }
  EXPECT_NEAR(sum / count, 3.0, 4.0 * std::sqrt(6.0 / count));
}

}  // namespace
}  // namespace dockyard::custom
