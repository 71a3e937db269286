#include "controller/vision/homography.h"

#include <gtest/gtest.h>

#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

/// The board's fiducials on the tangent plane of a camera 2 m before it, turned 35 deg off.
std::vector<PlanePair> TruePairs() {
  const FiducialBoard board = TestBoard();
  const Pose3 X_CB{.R = RotY(Radians(25.0)), .p = Eigen::Vector3d(1.4, 0.2, 2.0)};
  std::vector<Eigen::Vector3d> rays;
  for (const Fiducial& f : board.fiducials) {
    rays.push_back((X_CB * Eigen::Vector3d(f.p_BF.x(), f.p_BF.y(), 0.0)).normalized());
  }
  const TangentPlane plane = TangentPlaneAt(rays);
  std::vector<PlanePair> pairs;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    pairs.push_back({.board = board.fiducials[i].p_BF, .image = plane.FromRay(rays[i])});
  }
  return pairs;
}

TEST(TangentPlane, GivesRaysBack) {
  const TangentPlane plane = TangentPlaneAt({{0.5, -0.2, 0.7}, {0.6, 0.1, 0.5}});
  const Eigen::Vector3d ray = Eigen::Vector3d(0.9, 0.3, 0.4).normalized();
  EXPECT_NEAR((plane.ToRay(plane.FromRay(ray)) - ray).norm(), 0.0, 1e-12);
}

TEST(Homography, HoldsExactlyOnTheViewingSphere) {
  const std::vector<PlanePair> pairs = TruePairs();
  const auto H = FitHomography(pairs);
  ASSERT_TRUE(H);
  for (const PlanePair& pair : pairs) {
    EXPECT_NEAR((*Map(*H, pair.board) - pair.image).norm(), 0.0, 1e-10);
  }
}

TEST(Homography, DoesNotHoldInFisheyePixels) {
  // The same board fitted in equidistant pixels, f = 407 px, leaves pixels of error.
  const Camera camera = EquidistantCamera(640, 480, Radians(90.0));
  std::vector<PlanePair> pairs = TruePairs();
  const Eigen::Vector3d middle(1.4, 0.2, 2.0);
  const Pose3 X_CB{.R = RotY(Radians(25.0)), .p = 0.5 * middle};
  for (PlanePair& pair : pairs) {
    pair.image = *camera.Project(X_CB * Eigen::Vector3d(pair.board.x(), pair.board.y(), 0.0));
  }
  const auto H = FitHomography(pairs);
  ASSERT_TRUE(H);
  double worst = 0.0;
  for (const PlanePair& pair : pairs) {
    worst = std::max(worst, (*Map(*H, pair.board) - pair.image).norm());
  }
  EXPECT_GT(worst, 1.0);
}

TEST(Homography, NeedsFourPoints) {
  std::vector<PlanePair> pairs = TruePairs();
  pairs.resize(3);
  EXPECT_FALSE(FitHomography(pairs));
}

TEST(Homography, RefusesPointsOnALine) {
  std::vector<PlanePair> pairs;
  for (int i = 0; i < 6; ++i) pairs.push_back({.board = {0.1 * i, 0.0}, .image = {0.05 * i, 0.01}});
  EXPECT_FALSE(FitHomography(pairs));
}

TEST(RobustHomography, RejectsTwoFalsePointsOfEight) {
  std::vector<PlanePair> pairs = TruePairs();
  pairs[2].image += Eigen::Vector2d(0.05, -0.03);
  pairs[6].image += Eigen::Vector2d(-0.04, 0.06);
  const auto robust = FitHomographyRobust(pairs, 0.005);
  ASSERT_TRUE(robust);
  const std::vector<bool> expected{true, true, false, true, true, true, false, true};
  EXPECT_EQ(robust->inlier, expected);
  EXPECT_LT(robust->rms, 1e-9);
}

TEST(RobustHomography, RejectsOneFalsePointOfSix) {
  std::vector<PlanePair> pairs = TruePairs();
  pairs.resize(6);
  pairs[3].image.y() += 0.04;
  const auto robust = FitHomographyRobust(pairs, 0.002);
  ASSERT_TRUE(robust);
  EXPECT_FALSE(robust->inlier[3]);
}

TEST(RobustHomography, IsNotFooledByFivePointsOfWhichOneIsFalse) {
  // Four remaining points would fit anything: the paper's defect (V-D). Five must stay.
  std::vector<PlanePair> pairs = TruePairs();
  pairs.resize(5);
  pairs[1].image.x() += 0.05;
  EXPECT_FALSE(FitHomographyRobust(pairs, 0.002));
}

TEST(RobustHomography, RefusesFourPoints) {
  std::vector<PlanePair> pairs = TruePairs();
  pairs.resize(4);
  EXPECT_FALSE(FitHomographyRobust(pairs, 0.01));
}

}  // namespace
}  // namespace dockyard
