#include "controller/vision/planar_pose.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "controller/vision/board/pose_gates.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const FiducialBoard kBoard = TestBoard();

/// A lens with real distortion: k of OpenCV's fisheye test set (test_fisheye.cpp).
Camera DistortedCamera() {
  Camera camera = EquidistantCamera(1024, 768, Radians(90.0));
  std::get<KannalaBrandt>(camera.lens).k = {-0.00146, -0.0033, 0.00606, -0.00374};
  return camera;
}

std::vector<MarkPixel> Marks(const Camera& camera, const Pose3& X_CB) {
  std::vector<MarkPixel> marks;
  for (int id = 0; id < 8; ++id) {
    const auto pixel = ProjectDisc(camera, X_CB, kBoard.fiducials[static_cast<std::size_t>(id)],
                                   kBoard.disc_diameter_m);
    marks.push_back({.id = id, .view = 0, .pixel = *pixel});
  }
  return marks;
}

double Apart(const Pose3& a, const Pose3& b) {
  return (a.p - b.p).norm() + Eigen::AngleAxisd(a.R.transpose() * b.R).angle();
}

TEST(PlanarPose, IsExactAtTheBorderOfAFisheyeImage) {
  const Camera camera = DistortedCamera();
  for (const double off_axis : {0.0, 20.0, 38.0}) {
    const Eigen::Vector3d p = RotY(Radians(off_axis)) * Eigen::Vector3d(0.0, 0.1, 2.0);
    const Pose3 X_CB{.R = RotY(Radians(off_axis - 15.0)), .p = p};
    const auto branches = PlanarPose(Marks(camera, X_CB), camera, kBoard);
    ASSERT_FALSE(branches.empty());
    EXPECT_LT(Apart(branches[0].X_CB, X_CB), 1e-5) << off_axis << " deg off axis";
  }
}

TEST(PlanarPose, GivesBothPosesOfTheAmbiguity) {
  const Camera camera = EquidistantCamera(640, 480, Radians(90.0));
  const Pose3 X_CB{.R = RotY(Radians(25.0)), .p = {0.0, 0.0, 5.0}};
  const auto branches = PlanarPose(Marks(camera, X_CB), camera, kBoard);
  ASSERT_EQ(branches.size(), 2u);
  // The mirror image turns the other way, and explains the marks to a pixel.
  const double yaw = std::atan2(branches[1].X_CB.R(0, 2), branches[1].X_CB.R(2, 2));
  EXPECT_NEAR(yaw, Radians(-25.0), Radians(5.0));
  EXPECT_LT(branches[1].rms_px, 1.0);
}

TEST(PlanarPose, NeedsFourMarks) {
  const Camera camera = EquidistantCamera(640, 480, Radians(90.0));
  auto marks = Marks(camera, {.R = Eigen::Matrix3d::Identity(), .p = {0.0, 0.0, 2.0}});
  marks.resize(3);
  EXPECT_TRUE(PlanarPose(marks, camera, kBoard).empty());
}

/// Two mirrored branches as one camera would leave them, in a camera that points ahead.
std::vector<PlanarBranch> TwoBranches() {
  return {{.X_CB = {.R = RotY(Radians(15.0)), .p = {0, 0, 4}}, .rms_px = 0.2, .cost = 3.0},
          {.X_CB = {.R = RotY(Radians(-15.0)), .p = {0, 0, 4}}, .rms_px = 0.3, .cost = 5.0}};
}

TEST(BranchChoice, TakesTheBetterFitWithoutAnExpectation) {
  const Pose3 X_RC = TestRig(640, 480).X_RL;
  EXPECT_EQ(ChooseBranch(TwoBranches(), X_RC, {}), std::size_t{0});
}

TEST(BranchChoice, FollowsTheExpectationWhenTheFitsAreAlike) {
  const Pose3 X_RC = TestRig(640, 480).X_RL;
  LocateHints hints;
  hints.X_RB_expected = X_RC * TwoBranches()[1].X_CB;
  EXPECT_EQ(ChooseBranch(TwoBranches(), X_RC, hints), std::size_t{1});
}

TEST(BranchChoice, TakesNoneThatLiesOnItsSide) {
  const Pose3 X_RC = TestRig(640, 480).X_RL;
  LocateHints hints;
  hints.up_R = Eigen::Vector3d::UnitY();
  EXPECT_FALSE(ChooseBranch(TwoBranches(), X_RC, hints));
}

TEST(UprightGate, PassesALeaningStationAndStopsARolledOne) {
  const Eigen::Matrix3d R_RB = TestRig(640, 480).X_RL.R;  // face-on and plumb
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(IsUpright(R_RB, up));
  EXPECT_TRUE(IsUpright(R_RB * RotX(Radians(12.0)), up));
  EXPECT_FALSE(IsUpright(R_RB * RotZ(Radians(25.0)), up));
  EXPECT_FALSE(IsUpright(R_RB * RotZ(kPi), up));
}

TEST(FaceGate, StopsABoardSeenFromBehind) {
  EXPECT_TRUE(ShowsItsFace({.R = Eigen::Matrix3d::Identity(), .p = {0, 0, 2}}));
  EXPECT_FALSE(ShowsItsFace({.R = RotY(kPi), .p = {0, 0, 2}}));
  EXPECT_FALSE(ShowsItsFace({.R = Eigen::Matrix3d::Identity(), .p = {0, 0, -2}}));
}

}  // namespace
}  // namespace dockyard
