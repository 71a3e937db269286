#include "controller/vision/robust_planar_pose.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

std::vector<Eigen::Vector2d> Places(const FiducialBoard& board) {
  std::vector<Eigen::Vector2d> places;
  for (const Fiducial& fiducial : board.fiducials) places.push_back(fiducial.p_BF);
  return places;
}

Pose3 At(double z_m, double yaw_deg, double pitch_deg) {
  return {RotY(Radians(yaw_deg)) * RotX(Radians(pitch_deg)), {0.2, -0.1, z_m}};
}

std::vector<Eigen::Vector2d> Sights(const FiducialBoard& board, const Pose3& X_CB, double noise) {
  RandomStream random(7);
  std::vector<Eigen::Vector2d> sights;
  for (const Eigen::Vector2d& p : Places(board)) {
    const Eigen::Vector3d q = X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0);
    sights.push_back(q.hnormalized() + noise * Eigen::Vector2d(random.Normal(), random.Normal()));
  }
  return sights;
}

TEST(RobustPlanarPose, IsExactWithoutNoise) {
  const FiducialBoard board = TestBoard();
  for (const double yaw : {-40.0, -10.0, 5.0, 30.0}) {
    const Pose3 X_CB = At(2.0, yaw, 8.0);
    const auto minima = RobustPlanarPose(Places(board), Sights(board, X_CB, 0.0));
    ASSERT_FALSE(minima.empty());
    EXPECT_LT(Eigen::AngleAxisd(minima[0].X_CB.R.transpose() * X_CB.R).angle(), 1e-4) << yaw;
    EXPECT_LT((minima[0].X_CB.p - X_CB.p).norm(), 1e-3) << yaw;
  }
}

TEST(RobustPlanarPose, FindsBothMinimaOfAnObliquePlane) {
  // Weak perspective: the plane's normal mirrored about the line of sight fits nearly as well.
  const FiducialBoard board = TestBoard();
  const Pose3 X_CB = At(5.0, 25.0, 5.0);
  const auto minima = RobustPlanarPose(Places(board), Sights(board, X_CB, 1e-4));
  ASSERT_EQ(minima.size(), 2u);
  const Eigen::Vector3d sight = X_CB.p.normalized(), normal = X_CB.R.col(2);
  const Eigen::Vector3d mirrored = 2.0 * normal.dot(sight) * sight - normal;
  for (const PlanarMinimum& minimum : minima) {
    const Eigen::Vector3d n = minimum.X_CB.R.col(2);
    EXPECT_GT(std::max(n.dot(normal), n.dot(mirrored)), std::cos(Radians(5.0)));
  }
  EXPECT_LT(minima[0].error, minima[1].error);
}

TEST(RobustPlanarPose, TheLinearModelErrsAtAFisheyesBorder) {
  // The paper's footnote calls this unreliable: distortion left out. In the middle it does no harm.
  const FiducialBoard board = TestBoard();
  const Camera camera = EquidistantCamera(1024, 768, Radians(90.0));
  const auto error_m = [&](double aside_deg) {
    Pose3 X_CB = At(2.0, 10.0, 0.0);
    X_CB = Pose3{RotY(Radians(aside_deg)), Eigen::Vector3d::Zero()} * X_CB;
    std::vector<Eigen::Vector2d> sights;
    for (const Eigen::Vector2d& p : Places(board)) {
      sights.push_back(
          LinearSight(camera, *camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0))));
    }
    return (RobustPlanarPose(Places(board), sights)[0].X_CB.p - X_CB.p).norm();
  };
  EXPECT_LT(error_m(-6.0), 0.08);
  EXPECT_GT(error_m(28.0), 0.15);
}

TEST(RobustPlanarPose, NeedsFourPoints) {
  EXPECT_TRUE(RobustPlanarPose({{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {0.1, 0}, {0, 0.1}}).empty());
}

}  // namespace
}  // namespace dockyard
