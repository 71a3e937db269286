// The correspondence of the paper's pipeline on exact detections.
#include "controller/vision/board/tsai2013.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

const Camera kCamera = EquidistantCamera(1024, 768, Radians(90.0));
const FiducialBoard kBoard = TestBoard();

struct Marks {
  std::vector<DetectedFiducial> detections;  // from the bottom of the image upwards
  std::vector<int> ids;                      // of the detections; -1: false
};

DetectedFiducial Disc(const Eigen::Vector2d& pixel, double rotation_rad) {
  DetectedFiducial detection;
  detection.rim.centre_px = pixel;
  detection.rim.shape_px = 10.0 * Eigen::Matrix2d::Identity();
  detection.rotation_class = RotationClass(rotation_rad);
  return detection;
}

Marks Sorted(const Marks& marks) {
  std::vector<std::size_t> order(marks.ids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return marks.detections[a].rim.centre_px.y() > marks.detections[b].rim.centre_px.y();
  });
  Marks sorted;
  for (const std::size_t i : order) {
    sorted.detections.push_back(marks.detections[i]);
    sorted.ids.push_back(marks.ids[i]);
  }
  return sorted;
}

/// Those of a board 3 m ahead, but the given ones, with this noise.
Marks Seen(const std::vector<int>& without, double noise_px, std::uint64_t seed = 1) {
  RandomStream random(StreamKey(seed, "marks"));
  const Pose3 X_CB{.R = RotY(Radians(12.0)), .p = Eigen::Vector3d(0.2, -0.1, 3.0)};
  Marks marks;
  for (int id = 0; id < static_cast<int>(kBoard.fiducials.size()); ++id) {
    const Fiducial& fiducial = kBoard.fiducials[static_cast<std::size_t>(id)];
    const Eigen::Vector2d noise(random.Normal(), random.Normal());
    if (std::count(without.begin(), without.end(), id) > 0) continue;
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(fiducial.p_BF.x(), fiducial.p_BF.y(), 0.0);
    marks.detections.push_back(Disc(*kCamera.Project(p_C) + noise_px * noise, fiducial.rotation));
    marks.ids.push_back(id);
  }
  return Sorted(marks);
}

bool RightlyNamed(const Result<TsaiCorrespondence, PoseFailure>& found, const Marks& marks) {
  return found && std::all_of(found->matches.begin(), found->matches.end(), [&](const auto& match) {
           return marks.ids[static_cast<std::size_t>(match.detection)] == match.id;
         });
}

// Without one or two fiducials, the four of different rotations are not the first four.
TEST(TsaiCorrespondence, NamesTheRestWhicheverTwoAreMissing) {
  for (int a = 0; a < 8; ++a) {
    for (int b = a; b < 8; ++b) {
      const Marks marks = Seen({a, b}, 0.0);
      const auto found = CorrespondTsai2013(marks.detections, kBoard, {});
      ASSERT_TRUE(found) << a << b;
      EXPECT_TRUE(RightlyNamed(found, marks)) << a << b;
      EXPECT_EQ(found->matches.size(), marks.ids.size()) << a << b;
    }
  }
}

TEST(TsaiCorrespondence, NamesByTheLeastErrorAmongThoseThatTheRestVerifies) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Marks marks = Seen({}, 0.3, seed);
    const auto found = CorrespondTsai2013(marks.detections, kBoard, {});
    ASSERT_TRUE(found);
    EXPECT_TRUE(RightlyNamed(found, marks)) << seed;
    EXPECT_EQ(found->matches.size(), 8u) << seed;
  }
}

// Four pairs fit any homography without error, so the least error alone would take them.
TEST(TsaiCorrespondence, TakesFourOfEightWhereNothingVerifies) {
  VisionSettings unverified;
  unverified.tsai2013.agreeing_points = 4;
  const Marks marks = Seen({}, 0.3);
  const auto found = CorrespondTsai2013(marks.detections, kBoard, unverified);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->matches.size(), 4u);
}

// The known bug (Tsai et al., V-D), and its remedy.
TEST(TsaiCorrespondence, AFalseOneAmongTheFourIsVotedOutOnlyByAFifth) {
  Marks marks = Seen({5}, 0.0);
  const Eigen::Vector2d beside = marks.detections[0].rim.centre_px + Eigen::Vector2d(-60.0, 40.0);
  marks.detections.push_back(Disc(beside, kBoard.fiducials[5].rotation));
  marks.ids.push_back(-1);
  marks = Sorted(marks);
  const auto four = CorrespondTsai2013(marks.detections, kBoard, {});
  EXPECT_FALSE(four && four->matches.size() == 7u && RightlyNamed(four, marks));
  VisionSettings settings;
  settings.min_points = 5;
  const auto five = CorrespondTsai2013(marks.detections, kBoard, settings);
  ASSERT_TRUE(five);
  EXPECT_TRUE(RightlyNamed(five, marks));
}

TEST(TsaiCorrespondence, TheFourAreTakenByTheRankThatTheSettingsName) {
  // A false disc, the largest of its rotation and at the top, harms only those that take it.
  Marks marks = Seen({}, 0.0);
  DetectedFiducial wrong = Disc({900.0, 40.0}, kBoard.fiducials[0].rotation);
  wrong.rim.shape_px = 30.0 * Eigen::Matrix2d::Identity();
  marks.detections.push_back(wrong);
  marks.ids.push_back(-1);
  marks = Sorted(marks);
  for (const auto& [first, right] : {std::pair{Tsai2013First::kLowest, true},
                                     {Tsai2013First::kLeftmost, true},
                                     {Tsai2013First::kTopmost, false},
                                     {Tsai2013First::kLargest, false}}) {
    VisionSettings settings;
    settings.tsai2013.first = first;
    const auto found = CorrespondTsai2013(marks.detections, kBoard, settings);
    EXPECT_EQ(found && found->matches.size() == 8u && RightlyNamed(found, marks), right)
        << static_cast<int>(first);
  }
}

}  // namespace
}  // namespace dockyard
