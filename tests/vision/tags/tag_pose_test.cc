// Poses of rendered boards of tags against the truth.
#include "controller/vision/tags/tag_pose.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "controller/vision/tags/tag_code.h"
#include "vision/tags/tag_views.h"

namespace dockyard {
namespace {

/// The renderer's cameras are known exactly.
RefineOptions ExactCamera() {
  RefineOptions options;
  options.spread = {.focal = 0.0, .centre_px = 0.0, .radial_px = 0.0, .mounting_rad = 0.0};
  options.model_px = 0.0;
  return options;
}

double TurnBetween(const Pose3& a, const Pose3& b) {
  return Eigen::AngleAxisd(a.R.transpose() * b.R).angle();
}

/// Shift, then small turn about R's axes, as the covariance has them.
Eigen::Matrix<double, 6, 1> ErrorOf(const Pose3& found, const Pose3& truth) {
  const Eigen::AngleAxisd turn(found.R * truth.R.transpose());
  Eigen::Matrix<double, 6, 1> error;
  error << found.p - truth.p, turn.angle() * turn.axis();
  return error;
}

/// A board with a tag in each corner.
FiducialBoard FourTags() {
  FiducialBoard board{.width_m = 0.3, .height_m = 0.2, .fiducials = {}};
  for (int i = 0; i < 4; ++i) {
    board.tags.push_back({.family = "aruco_4x4_50",
                          .id = i,
                          .p_BT = {i % 2 ? 0.1 : -0.1, i < 2 ? -0.05 : 0.05},
                          .size_m = 0.05,
                          .rotation = Radians(90.0 * i)});
  }
  SetTagCells(board);
  return board;
}

TEST(TagPose, LiesWhereTheBoardIsInTheRobotsBody) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  const FiducialBoard board = OneTag("tag36h11", 7, 0.1);
  const TagImage image =
      RenderTags(renderer, board, camera, {.range_m = 0.6, .yaw_rad = Radians(30)}, 1);
  const Pose3 X_RC{RotZ(-kPi / 2) * RotX(-kPi / 2), {0.2, 0.05, 0.3}};
  const TagSighting sighting = LocateTagBoard(image.image, {camera, X_RC}, board, ExactCamera());
  ASSERT_FALSE(sighting.branches.empty());
  EXPECT_EQ(sighting.used, std::vector<int>{0});
  const TagBranch& best = sighting.branches[0];
  const Pose3 truth = X_RC * image.X_CB;
  EXPECT_LT((best.X_RB.p - truth.p).norm(), 1e-3);
  EXPECT_LT(TurnBetween(best.X_RB, truth), Radians(0.5));
  EXPECT_LT(best.rms_px, 0.1);
}

TEST(TagPose, ErrorsFollowTheCovariance) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  const FiducialBoard board = OneTag("tag36h11", 7, 0.1);
  const TagFinder finder("tag36h11");
  double sum = 0.0;
  constexpr int kViews = 20;
  for (int i = 0; i < kViews; ++i) {
    const TagPlace place{.range_m = 0.9 + 0.07 * i,
                         .yaw_rad = Radians(25 + i),
                         .pitch_rad = Radians(i - 10),
                         .roll_rad = Radians(7.0 * i),
                         .aim_rad = {Radians(0.37 * i), Radians(0.21 * i)}};
    const TagImage image =
        RenderTags(renderer, board, camera, place, static_cast<std::uint64_t>(i + 1));
    const TagSighting sighting = TagBoardPose(finder.Find(image.image, &camera), "tag36h11",
                                              {camera, {}}, board, ExactCamera());
    ASSERT_FALSE(sighting.branches.empty());
    const TagBranch& best = sighting.branches[0];
    EXPECT_LT(TurnBetween(best.X_RB, image.X_CB), Radians(2.0)) << i;
    const auto error = ErrorOf(best.X_RB, image.X_CB);
    sum += error.dot(best.covariance.inverse() * error) / 6.0;
  }
  std::printf("mean of the squared errors over the covariance: %.2f\n", sum / kViews);
  // 1 if the corners' errors were normal and independent; two corners share an edge.
  EXPECT_GT(sum / kViews, 0.2);
  EXPECT_LT(sum / kViews, 3.0);
}

TEST(TagPose, HasBothBranchesOfAFarTag) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(90));
  const FiducialBoard board = OneTag("tag36h11", 7, 0.1);
  const TagImage image =
      RenderTags(renderer, board, camera, {.range_m = 2.0, .yaw_rad = Radians(25)}, 4);
  const TagSighting sighting = LocateTagBoard(image.image, {camera, {}}, board, ExactCamera());
  ASSERT_EQ(sighting.branches.size(), 2u);
  EXPECT_LE(sighting.branches[0].cost, sighting.branches[1].cost);
  double least = 1e9;
  for (const TagBranch& branch : sighting.branches) {
    least = std::min(least, TurnBetween(branch.X_RB, image.X_CB));
    // The normals are mirrored about the line of sight.
    const Eigen::Vector3d sight = image.X_CB.p.normalized();
    EXPECT_NEAR(branch.X_RB.R.col(2).dot(sight), image.X_CB.R.col(2).dot(sight), 0.05);
  }
  EXPECT_LT(least, Radians(3));
}

TEST(TagPose, OfFourTagsIsSharperThanOfOne) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  FiducialBoard board = FourTags();
  const TagImage image =
      RenderTags(renderer, board, camera, {.range_m = 0.9, .yaw_rad = Radians(20)}, 1);
  const TagSighting all = LocateTagBoard(image.image, {camera, {}}, board, ExactCamera());
  EXPECT_EQ(all.used.size(), 4u);
  ASSERT_FALSE(all.branches.empty());
  EXPECT_LT(TurnBetween(all.branches[0].X_RB, image.X_CB), Radians(0.5));
  EXPECT_LT((all.branches[0].X_RB.p - image.X_CB.p).norm(), 2e-3);
  board.tags.resize(1);
  const TagSighting one = LocateTagBoard(image.image, {camera, {}}, board, ExactCamera());
  ASSERT_FALSE(one.branches.empty());
  for (int k = 0; k < 6; ++k) {
    EXPECT_LT(all.branches[0].covariance(k, k), one.branches[0].covariance(k, k)) << k;
  }
}

TEST(TagPose, LeavesOutTagsFoundTwiceAndTagsOfOthers) {
  const FiducialBoard board = FourTags();
  FoundTag tag{.id = 2, .corners = {{{10, 10}, {20, 10}, {20, 20}, {10, 20}}}, .sigma_px = 0.1};
  const CameraView view{Pinhole(640, 480, Radians(75)), {}};
  EXPECT_TRUE(TagBoardPose({tag, tag}, "aruco_4x4_50", view, board).branches.empty());
  EXPECT_TRUE(TagBoardPose({tag}, "tag36h11", view, board).branches.empty());
  EXPECT_TRUE(TagBoardPose({}, "aruco_4x4_50", view, board).branches.empty());
  EXPECT_FALSE(TagBoardPose({tag}, "aruco_4x4_50", view, board).branches.empty());
}

}  // namespace
}  // namespace dockyard
