#include "controller/vision/board/correspond.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const Camera kCamera = EquidistantCamera(1024, 768, Radians(90.0));
const Eigen::Vector3d kUp_C(0.0, -1.0, 0.0);

Pose3 BoardAt(double range_m, double yaw_rad) {
  return {.R = RotY(yaw_rad) * RotX(Radians(5.0)), .p = Eigen::Vector3d(0.3, -0.1, range_m)};
}

DetectedFiducial Detected(const Eigen::Vector2d& pixel, double radius_px, int rotation_class) {
  DetectedFiducial detection;
  detection.rim.centre_px = pixel;
  detection.rim.shape_px = radius_px * Eigen::Matrix2d::Identity();
  detection.match = 0.95;
  detection.rotation_class = rotation_class;
  detection.rotation_margin = 0.5;
  return detection;
}

/// The detections of a perfect detector, fiducial by fiducial.
std::vector<DetectedFiducial> Detections(const FiducialBoard& board, const Pose3& X_CB) {
  std::vector<DetectedFiducial> detections;
  for (const Fiducial& f : board.fiducials) {
    const Eigen::Vector2d pixel = *ProjectDisc(kCamera, X_CB, f, board.disc_diameter_m);
    const double radius =
        0.05 * kCamera.focal_px().x() / X_CB.p.norm() * std::sqrt(std::abs(X_CB.R.col(2).z()));
    detections.push_back(Detected(pixel, radius, RotationClass(f.rotation)));
  }
  return detections;
}

/// Fiducial of each detection, as the result names it.
std::map<int, int> IdByDetection(const Correspondence& found) {
  std::map<int, int> ids;
  for (const MarkMatch& match : found.matches) ids[match.detection] = match.id;
  return ids;
}

class SixteenHypotheses : public testing::TestWithParam<int> {};

TEST_P(SixteenHypotheses, EachIsFoundWhenItIsTheTruth) {
  // The two fiducials of a rotation change names where a bit is set, so that of the 16 namings of
  // the same image each is right once.
  const FiducialBoard named = TestBoard();
  FiducialBoard renamed = named;
  std::vector<int> truth{0, 1, 2, 3, 4, 5, 6, 7};
  for (int c = 0; c < 4; ++c) {
    if ((GetParam() >> c & 1) == 0) continue;
    std::vector<std::size_t> pair;
    for (std::size_t i = 0; i < 8; ++i) {
      if (RotationClass(named.fiducials[i].rotation) == c) pair.push_back(i);
    }
    std::swap(renamed.fiducials[pair[0]], renamed.fiducials[pair[1]]);
    std::swap(truth[pair[0]], truth[pair[1]]);
  }
  const auto detections = Detections(named, BoardAt(3.0, Radians(20.0)));
  const auto found = Correspond(detections, kCamera, renamed, kUp_C);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->matches.size(), 8u);
  for (const MarkMatch& match : found->matches) {
    EXPECT_EQ(match.id, truth[static_cast<std::size_t>(match.detection)]);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SixteenHypotheses, testing::Range(0, 16));

TEST(Correspondence, SurvivesTwoHiddenAndOneFalseMark) {
  const FiducialBoard board = TestBoard();
  auto detections = Detections(board, BoardAt(3.0, Radians(-25.0)));
  detections.erase(detections.begin() + 5);
  detections.erase(detections.begin() + 2);
  detections.push_back(Detected({600.0, 500.0}, 10.0, RotationClass(Radians(90.0))));
  const auto found = Correspond(detections, kCamera, board, kUp_C);
  ASSERT_TRUE(found);
  const std::map<int, int> expected{{0, 0}, {1, 1}, {2, 3}, {3, 4}, {4, 6}, {5, 7}};
  EXPECT_EQ(IdByDetection(*found), expected);
}

TEST(Correspondence, FillsHiddenFiducialsInWhereTheyAre) {
  const FiducialBoard board = TestBoard();
  const Pose3 X_CB = BoardAt(2.5, Radians(15.0));
  auto detections = Detections(board, X_CB);
  detections.erase(detections.begin() + 6);
  const auto found = Correspond(detections, kCamera, board, kUp_C);
  ASSERT_TRUE(found);
  const auto truth = ProjectDisc(kCamera, X_CB, board.fiducials[6], board.disc_diameter_m);
  EXPECT_LT((found->centres[6] - *truth).norm(), 0.3);
}

TEST(Correspondence, SurvivesTwoMisreadRotations) {
  const FiducialBoard board = TestBoard();
  auto detections = Detections(board, BoardAt(4.0, Radians(10.0)));
  for (const std::size_t misread : {1u, 4u}) {
    detections[misread].rotation_class = (detections[misread].rotation_class + 1) % 4;
    detections[misread].rotation_margin = 0.04;
  }
  const auto found = Correspond(detections, kCamera, board, kUp_C);
  ASSERT_TRUE(found);
  const std::map<int, int> expected{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {7, 7}};
  EXPECT_EQ(IdByDetection(*found), expected);
}

TEST(Correspondence, DoesNotSeeTheBoardUpsideDown) {
  const FiducialBoard board = TestBoard();
  Pose3 X_CB = BoardAt(3.0, 0.0);
  X_CB.R = X_CB.R * RotZ(kPi);
  // Half a turn leaves every bar's direction as it was.
  const auto found = Correspond(Detections(board, X_CB), kCamera, board, kUp_C);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error(), PoseFailure::kNoCorrespondence);
}

TEST(Correspondence, RefusesMarksOfTheWrongSize) {
  const FiducialBoard board = TestBoard();
  auto detections = Detections(board, BoardAt(3.0, 0.0));
  for (DetectedFiducial& detection : detections) detection.rim.shape_px *= 1.6;
  EXPECT_FALSE(Correspond(detections, kCamera, board, kUp_C));
}

TEST(Correspondence, NeedsFiveMarks) {
  const FiducialBoard board = TestBoard();
  auto detections = Detections(board, BoardAt(3.0, 0.0));
  detections.resize(4);
  const auto found = Correspond(detections, kCamera, board, kUp_C);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error(), PoseFailure::kTooFewFiducials);
}

TEST(MatchByPose, LeavesFarMarksAlone) {
  const FiducialBoard board = TestBoard();
  const Pose3 X_CB = BoardAt(3.0, 0.0);
  auto detections = Detections(board, X_CB);
  detections[3].rim.centre_px.x() += 9.0;
  const auto matches = MatchByPose(detections, kCamera, board, X_CB, 4.0);
  EXPECT_EQ(matches.size(), 7u);
}

}  // namespace
}  // namespace dockyard
