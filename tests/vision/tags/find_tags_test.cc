// Rendered tags are found where they project.
#include "controller/vision/tags/find_tags.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/vision/tags/april_finder.h"
#include "controller/vision/tags/tag_code.h"
#include "vision/tags/tag_views.h"

namespace dockyard {
namespace {

double WorstOff(const std::array<Eigen::Vector2d, 4>& a, const std::array<Eigen::Vector2d, 4>& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < 4; ++k) worst = std::max(worst, (a[k] - b[k]).norm());
  return worst;
}

struct Case {
  const char* family;
  double fov_deg;
};

class FoundTags : public testing::TestWithParam<Case> {};

TEST_P(FoundTags, HaveTheirIdAndTheirCornersToATenthOfAPixel) {
  const auto [family, fov_deg] = GetParam();
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(fov_deg));
  const TagFinder finder(family);
  std::uint64_t key = 1;
  for (const double range_m : {0.3, 0.8, 1.5, 2.5}) {
    const FiducialBoard board = OneTag(family, 7, 0.1);
    // Squares under 1.5 px cannot be read: 0.1 m of eight squares at 2.5 m and 90 deg have 1.6.
    for (const double yaw_deg : {0.0, 35.0}) {
      if (yaw_deg > 0.0 && range_m > 2.0 && fov_deg > 80.0) continue;
      const TagPlace place{.range_m = range_m,
                           .yaw_rad = Radians(yaw_deg),
                           .pitch_rad = Radians(8),
                           .roll_rad = Radians(11),
                           .aim_rad = {Radians(2), Radians(-1)}};
      const TagImage view = RenderTags(renderer, board, camera, place, ++key);
      const std::vector<FoundTag> tags = finder.Find(view.image, &camera);
      ASSERT_EQ(tags.size(), 1u) << family << " at " << range_m << " m, " << yaw_deg << " deg";
      EXPECT_EQ(tags[0].id, 7);
      EXPECT_TRUE(tags[0].fitted);
      EXPECT_GT(tags[0].decision_margin, 10.0);
      EXPECT_LT(WorstOff(tags[0].corners, TrueCorners(view, board.tags[0])), 0.1)
          << family << " at " << range_m << " m, " << yaw_deg << " deg";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, FoundTags,
                         testing::Values(Case{"tag16h5", 60}, Case{"tag36h11", 60},
                                         Case{"tag36h11", 90}, Case{"tagStandard41h12", 60},
                                         Case{"aruco_4x4_50", 60}, Case{"aruco_4x4_50", 90},
                                         Case{"aruco_6x6_250", 60}, Case{"aruco_original", 60}));

// libapriltag finds straight edges. At 35 deg off the axis of a wide lens a near tag's are bent.
TEST(FoundTag, ThroughAWideLensHasItsCornersByTheRays) {
  StereoRenderer renderer;
  Camera camera = EquidistantCamera(640, 480, Radians(100));
  std::get<KannalaBrandt>(camera.lens).k = {-0.02, 0.004, 0.0, 0.0};
  for (const char* family : {"tag36h11", "aruco_4x4_50"}) {
    const FiducialBoard board = OneTag(family, 7, 0.1);
    for (const double range_m : {0.3, 0.6, 1.2}) {
      const TagPlace place{
          .range_m = range_m, .yaw_rad = Radians(25), .aim_rad = {Radians(33), Radians(3)}};
      const TagImage view = RenderTags(renderer, board, camera, place, 3);
      const auto truth = TrueCorners(view, board.tags[0]);
      const std::vector<FoundTag> tags = FindTags(view.image, family, &camera);
      ASSERT_EQ(tags.size(), 1u) << family << " at " << range_m << " m";
      EXPECT_LT(WorstOff(tags[0].corners, truth), 0.1) << family << " at " << range_m << " m";
      if (range_m > 0.5 || tags[0].hamming != 0 || std::string(family) != "tag36h11") continue;
      EXPECT_GT(WorstOff(AprilFinder(family).Find(view.image)[0].corners, truth), 0.5);
    }
  }
}

TEST(FoundTag, PredictsTheErrorOfItsCorners) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  const FiducialBoard board = OneTag("tag36h11", 7, 0.1);
  const TagFinder finder("tag36h11");
  double squares = 0.0;
  constexpr int kViews = 16;
  for (int i = 0; i < kViews; ++i) {
    const TagPlace place{.range_m = 1.0 + 0.08 * i,
                         .yaw_rad = Radians(10 + i),
                         .roll_rad = Radians(5.0 * i),
                         .aim_rad = {Radians(0.37 * i), Radians(0.21 * i)}};
    const TagImage view =
        RenderTags(renderer, board, camera, place, static_cast<std::uint64_t>(i + 1));
    const std::vector<FoundTag> tags = finder.Find(view.image, &camera);
    ASSERT_EQ(tags.size(), 1u);
    const auto truth = TrueCorners(view, board.tags[0]);
    for (std::size_t k = 0; k < 4; ++k) {
      squares += (tags[0].corners[k] - truth[k]).squaredNorm() / std::pow(tags[0].sigma_px, 2);
    }
  }
  const double ratio = std::sqrt(squares / (8.0 * kViews));
  std::printf("error over predicted error: %.2f\n", ratio);
  EXPECT_GT(ratio, 0.4);
  EXPECT_LT(ratio, 2.0);
}

TEST(FoundTag, UnderTheEdgeOfAShadeHasItsCornersToTheirPrediction) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  const FiducialBoard board = OneTag("tag36h11", 7, 0.1);
  const TagFinder finder("tag36h11");
  double squares = 0.0;
  int found = 0;
  constexpr int kViews = 32;
  for (int i = 0; i < kViews; ++i) {
    const TagPlace place{.range_m = 0.5 + 0.04 * i,
                         .yaw_rad = Radians(1.0 * i),
                         .roll_rad = Radians(5.0 * i),
                         .aim_rad = {Radians(0.37 * i), Radians(0.21 * i)}};
    TagImage view = RenderTags(renderer, board, camera, place, static_cast<std::uint64_t>(i + 1));
    const auto truth = TrueCorners(view, board.tags[0]);
    // It leaves one corner and the middle in the shade or in the light, by turns.
    const auto k = static_cast<std::size_t>(i % 4);
    const Eigen::Vector2d at = 0.7 * truth[k] + 0.3 * truth[(k + 2) % 4];
    const double side_px = (truth[1] - truth[0]).norm();
    view.image = Shaded(view.image, at, 0.7 * i, 0.2 * side_px, 0.4);
    const std::vector<FoundTag> tags = finder.Find(view.image, &camera);
    if (tags.empty()) continue;
    ++found;
    EXPECT_LT(WorstOff(tags[0].corners, truth), 0.3) << i;
    for (std::size_t c = 0; c < 4; ++c) {
      squares += (tags[0].corners[c] - truth[c]).squaredNorm() / std::pow(tags[0].sigma_px, 2);
    }
  }
  EXPECT_GE(found, kViews - 2);
  const double ratio = std::sqrt(squares / (8.0 * found));
  std::printf("%d found, error over predicted error: %.2f\n", found, ratio);
  EXPECT_LT(ratio, 3.0);
}

TEST(FoundTag, IsThereWhereAShadeLeavesThreeTenthsOfTheLight) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  const FiducialBoard board = OneTag("tag36h11", 7, 0.1);
  const TagFinder finder("tag36h11");
  int found = 0;
  constexpr int kViews = 16;
  for (int i = 0; i < kViews; ++i) {
    const TagPlace place{.range_m = 1.6, .yaw_rad = Radians(2.0 * i), .roll_rad = Radians(i)};
    TagImage view = RenderTags(renderer, board, camera, place, static_cast<std::uint64_t>(i + 1));
    const auto truth = TrueCorners(view, board.tags[0]);
    // Its edge is along the tag's left side, and the whole image is as dark as one of a lit wall.
    view.image = Shaded(view.image, 0.5 * (truth[0] + truth[3]), 0.0, 4.0, 0.3);
    for (std::uint8_t& grey : view.image.pixels) grey = static_cast<std::uint8_t>(0.6 * grey);
    found += finder.Find(view.image, &camera).size() == 1u;
  }
  EXPECT_GE(found, kViews - 2);
}

TEST(FoundTag, IsThereFromNearWithATwentiethOfItsInkGone) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(69));
  const TagFinder finder("tag36h11");
  int found = 0;
  constexpr int kPrints = 24;
  for (int i = 0; i < kPrints; ++i) {
    BoardView printed{.board = OneTag("tag36h11", 7, 0.1), .X_WB = {}, .dusty_spots = {}};
    printed.wear = 0.05;
    printed.wear_seed = static_cast<std::uint64_t>(i + 1);
    const TagImage view = RenderTags(renderer, printed, camera, {.range_m = 0.25}, 1);
    const std::vector<FoundTag> tags = finder.Find(view.image, &camera);
    if (tags.empty()) continue;
    ++found;
    EXPECT_LT(WorstOff(tags[0].corners, TrueCorners(view, printed.board.tags[0])), 0.2) << i;
  }
  EXPECT_EQ(found, kPrints);
}

TEST(FoundTag, OfAWornAndDustyBoardIsStillThere) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  BoardView view{.board = OneTag("tag36h11", 7, 0.1), .X_WB = {}, .dusty_spots = {}};
  view.dust_cover = 0.3;
  view.wear = 0.1;
  const TagImage image =
      RenderTags(renderer, view, camera, {.range_m = 0.7, .yaw_rad = Radians(20)}, 1);
  const std::vector<FoundTag> tags = FindTags(image.image, "tag36h11", &camera);
  ASSERT_EQ(tags.size(), 1u);
  EXPECT_EQ(tags[0].id, 7);
  EXPECT_LT(WorstOff(tags[0].corners, TrueCorners(image, view.board.tags[0])), 0.5);
}

TEST(FoundTags, AreTheSameInEverySearch) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(75));
  FiducialBoard board{.width_m = 0.4, .height_m = 0.2, .fiducials = {}};
  for (const int id : {5, 3}) {
    board.tags.push_back({.family = "tag36h11",
                          .id = id,
                          .p_BT = {id == 5 ? -0.1 : 0.1, 0.0},
                          .size_m = 0.1,
                          .rotation = Radians(10.0 * id)});
  }
  SetTagCells(board);
  const TagImage view = RenderTags(renderer, board, camera, {.range_m = 0.8}, 1);
  const TagImage other = RenderTags(renderer, board, camera, {.range_m = 1.3}, 2);
  const TagFinder finder("tag36h11");
  const std::vector<FoundTag> first = finder.Find(view.image, &camera);
  finder.Find(other.image, &camera);
  const std::vector<FoundTag> second = finder.Find(view.image, &camera);
  const std::vector<FoundTag> third = FindTags(view.image, "tag36h11", &camera);
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].id, 3);  // by id
  EXPECT_EQ(first[1].id, 5);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(WorstOff(first[i].corners, TrueCorners(view, board.tags[1 - i])), 0.1);
    for (const auto& again : {second, third}) {
      EXPECT_EQ(again[i].corners, first[i].corners);
      EXPECT_EQ(again[i].sigma_px, first[i].sigma_px);
    }
  }
}

TEST(FoundTags, AreNoneInAnEmptyImage) {
  for (const char* family : {"tag36h11", "aruco_4x4_50"}) {
    const TagFinder finder(family);
    for (const int side : {1, 15, 16, 64}) {
      const GrayImage grey{side, side,
                           std::vector<std::uint8_t>(static_cast<std::size_t>(side * side), 90)};
      EXPECT_TRUE(finder.Find(grey, nullptr).empty());
    }
  }
}

}  // namespace
}  // namespace dockyard
