// The squares of tags equal those that the detectors' own libraries draw.
#include <apriltag/apriltag.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/aruco.hpp>

#include "controller/geometry/pose.h"
#include "controller/vision/tags/april_families.h"
#include "controller/vision/tags/tag_code.h"

namespace dockyard {
namespace {

std::vector<int> Every(int step, int ids) {
  std::vector<int> some;
  for (int id = 0; id < ids; id += step) some.push_back(id);
  some.push_back(ids - 1);
  return some;
}

class AprilCodes : public testing::TestWithParam<std::string> {};

TEST_P(AprilCodes, AreThoseOfLibapriltag) {
  const auto family = TagFamilyNamed(GetParam());
  ASSERT_TRUE(family);
  EXPECT_FALSE(family->aruco);
  const AprilFamily april = AprilFamilyNamed(GetParam());
  EXPECT_EQ(family->ids, static_cast<int>(april->ncodes));
  const std::vector<int> ids = Every(1 + family->ids / 500, family->ids);
  const std::vector<TagCells> tags = CellsOf(*family, ids);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    image_u8_t* drawn = apriltag_to_image(april.get(), ids[i]);
    ASSERT_EQ(drawn->width, tags[i].across);
    for (int y = 0; y < drawn->height; ++y) {
      for (int x = 0; x < drawn->width; ++x) {
        ASSERT_EQ(tags[i].IsBlack(x, y), drawn->buf[y * drawn->stride + x] == 0)
            << "id " << ids[i] << " at " << x << ", " << y;
      }
    }
    std::free(drawn->buf);  // the library's own function for this is not public
    std::free(drawn);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, AprilCodes,
                         testing::Values("tag16h5", "tag25h9", "tag36h11", "tagStandard41h12",
                                         "tagStandard52h13"));

TEST(ArucoCodes, AreThoseThatOpenCvDraws) {
  int dictionary = 0;
  for (const std::string& name : TagFamilyNames()) {
    const auto family = TagFamilyNamed(name);
    ASSERT_TRUE(family);
    if (!family->aruco) continue;
    const auto drawn_by = cv::aruco::getPredefinedDictionary(dictionary++);
    ASSERT_EQ(family->ids, drawn_by->bytesList.rows) << name;
    ASSERT_EQ(family->at_border, drawn_by->markerSize + 2) << name;
    const std::vector<int> ids = Every(3, family->ids);
    const std::vector<TagCells> tags = CellsOf(*family, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      cv::Mat drawn;
      cv::aruco::drawMarker(drawn_by, ids[i], family->at_border, drawn);
      for (int y = 0; y < drawn.rows; ++y) {
        for (int x = 0; x < drawn.cols; ++x) {
          ASSERT_EQ(tags[i].IsBlack(x + 1, y + 1), drawn.at<std::uint8_t>(y, x) == 0)
              << name << " id " << ids[i] << " at " << x << ", " << y;
        }
      }
    }
  }
  EXPECT_EQ(dictionary, 17);  // 4 x 4 to 7 x 7 in four sizes each, and the original one
}

TEST(TagCodes, MarginsAreWhiteAndTheRingInsideIsBlack) {
  for (const std::string& name : TagFamilyNames()) {
    const auto family = TagFamilyNamed(name);
    const TagCells cells = CellsOf(*family, {family->ids / 2})[0];
    if (family->margin == 0) continue;
    for (int i = 0; i < cells.across; ++i) {
      EXPECT_FALSE(cells.IsBlack(i, 0) || cells.IsBlack(0, i)) << name;
      const bool corner = i == 0 || i == cells.across - 1;
      EXPECT_EQ(cells.IsBlack(i, 1), !corner) << name;
    }
  }
  EXPECT_FALSE(TagFamilyNamed("tag36h12"));
}

TEST(TagCodes, CornersGoRoundFromTheTopLeft) {
  SquareTag tag{.id = 0, .p_BT = {0.5, 0.2}, .size_m = 0.2};
  const auto level = CornersOf(tag);
  EXPECT_LT((level[0] - Eigen::Vector2d(0.4, 0.1)).norm(), 1e-12);
  EXPECT_LT((level[1] - Eigen::Vector2d(0.6, 0.1)).norm(), 1e-12);
  EXPECT_LT((level[2] - Eigen::Vector2d(0.6, 0.3)).norm(), 1e-12);
  EXPECT_LT((level[3] - Eigen::Vector2d(0.4, 0.3)).norm(), 1e-12);
  // A quarter turn counter-clockwise brings the top left corner to the bottom left.
  tag.rotation = kPi / 2;
  EXPECT_LT((CornersOf(tag)[0] - Eigen::Vector2d(0.4, 0.3)).norm(), 1e-12);
}

}  // namespace
}  // namespace dockyard
