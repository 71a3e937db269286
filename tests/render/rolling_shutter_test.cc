// Rows that are exposed one after another, against closed forms.
#include "render/rolling_shutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dockyard {
namespace {

constexpr int kColumns = 120, kLines = 90;
constexpr double kFocal_px = 4000.0;  // narrow: a turn moves all pixels alike, to 1e-4
constexpr double kEdgeAt = 60.3, kEdgeSigma_px = 1.2;

Camera NarrowCamera() {
  return {.width = kColumns,
          .height = kLines,
          .lens = BrownPinhole{.fx = kFocal_px, .fy = kFocal_px, .cx = 59.5, .cy = 44.5}};
}

double SoftEdge(double from_edge_px) {
  return 0.5 * std::erfc(-from_edge_px / (kEdgeSigma_px * std::numbers::sqrt2));
}

/// An upright edge at u_px.
RadianceImage UprightEdge(double u_px, double inverse_depth) {
  RadianceImage image{.width = kColumns, .height = kLines, .values = {}, .inverse_depth = {}};
  for (int i = 0; i < kColumns * kLines; ++i) {
    image.values.push_back(static_cast<float>(SoftEdge(i % kColumns - u_px)));
  }
  image.inverse_depth.assign(image.values.size(), static_cast<float>(inverse_depth));
  return image;
}

double TimeOfRow(int y) { return (y + 0.5) / kLines - 0.5; }

/// Mean place and variance of the edge in a row, by its slope.
struct RowEdge {
  double mean = 0.0, variance = 0.0;
};
RowEdge EdgeInRow(const RadianceImage& image, int y) {
  RowEdge edge;
  double sum = 0.0, second = 0.0;
  for (int x = 1; x < kColumns; ++x) {
    const double slope = image.at(x, y) - image.at(x - 1, y);
    sum += slope;
    edge.mean += slope * (x - 0.5);
    second += slope * (x - 0.5) * (x - 0.5);
  }
  edge.mean /= sum;
  edge.variance = second / sum - edge.mean * edge.mean;
  return edge;
}

// A camera that turns to the left at a known rate shows far things further right, row by row: at
// rate times focal length times the row's time.
TEST(RollingShutter, RowsOfAPanAreDisplacedByRateTimesTime) {
  const double still = EdgeInRow(UprightEdge(kEdgeAt, 0.0), 0).variance;
  for (const double d : {0.15, 0.6, 1.0, 3.3, 8.0, 30.0}) {
    const ExposureMotion turning{{0, 0, 0}, {0, -d / kFocal_px, 0}};
    int views = 0;
    const RadianceImage rows =
        OverReadout(d, NarrowCamera(), turning, OneInReadout([&](double share) {
                      ++views;
                      return UprightEdge(kEdgeAt + share * d, 0.0);
                    }));
    EXPECT_EQ(views, std::min(16.0, std::ceil(d)));
    for (int y = 0; y < kLines; ++y) {
      const RowEdge edge = EdgeInRow(rows, y);
      ASSERT_NEAR(edge.mean, kEdgeAt + d * TimeOfRow(y), 2e-3 + 2e-4 * d) << d << " row " << y;
      ASSERT_NEAR(edge.variance, still, 5e-3) << d << " row " << y;
    }
  }
}

TEST(RollingShutter, OfATravellingCameraNearThingsAreDisplacedByTheirDistance) {
  for (const double distance_m : {0.5, 2.0}) {
    const double shift_m = 0.001;  // to the left: things go right
    const double d = kFocal_px * shift_m / distance_m;
    const ExposureMotion travel{{-shift_m, 0, 0}, {0, 0, 0}};
    const RadianceImage rows =
        OverReadout(d, NarrowCamera(), travel, OneInReadout([&](double share) {
                      return UprightEdge(kEdgeAt + share * d, 1.0 / distance_m);
                    }));
    for (int y = 0; y < kLines; y += 7) {
      ASSERT_NEAR(EdgeInRow(rows, y).mean, kEdgeAt + d * TimeOfRow(y), 4e-3) << distance_m;
    }
  }
}

// A level edge that goes down while the rows are exposed: row y shows it as it is at its time.
TEST(RollingShutter, ATiltStretchesTheImage) {
  constexpr double kEdgeRow = 52.2;
  for (const double d : {0.8, 5.0}) {
    const ExposureMotion turning{{0, 0, 0}, {d / kFocal_px, 0, 0}};
    const auto level = [&](double share) {
      RadianceImage image = UprightEdge(0.0, 0.0);
      for (std::size_t i = 0; i < image.values.size(); ++i) {
        const double y = static_cast<double>(i / kColumns);
        image.values[i] = static_cast<float>(SoftEdge(y - kEdgeRow - share * d));
      }
      return image;
    };
    const RadianceImage rows = OverReadout(d, NarrowCamera(), turning, OneInReadout(level));
    for (int y = 0; y < kLines; ++y) {
      const double expected = SoftEdge(y - kEdgeRow - TimeOfRow(y) * d);
      // The polynomial is off by 0.6 % of a step of this width, in the middle between two pixels.
      ASSERT_NEAR(rows.at(40, y), expected, 6e-3) << d << " row " << y;
    }
  }
}

TEST(RollingShutter, AtRestOneViewServesAllRowsToTheBit) {
  const StereoRig rig{NarrowCamera(), NarrowCamera(), {}, {}};
  int views = 0;
  const StereoRadiance rows = OverReadout(0.09, rig, {}, [&](double share) -> StereoRadiance {
    ++views;
    EXPECT_EQ(share, 0.0);
    return {UprightEdge(20.0, 0.0), UprightEdge(70.0, 0.0)};
  });
  EXPECT_EQ(views, 1);
  EXPECT_EQ(rows[0].values, UprightEdge(20.0, 0.0).values);
  EXPECT_EQ(rows[1].values, UprightEdge(70.0, 0.0).values);
}

TEST(RollingShutter, BothCamerasOfAPairGetTheirOwnMotion) {
  // A turn about the left camera moves the right one ahead, which far things do not show.
  const StereoRig rig{NarrowCamera(), NarrowCamera(), {}, Pose3::Translation(0.3, 0.0, 0.0)};
  constexpr double kMotion_px = 2.0;
  const ExposureMotion turning{{0, 0, 0}, {0, -kMotion_px / kFocal_px, 0}};
  const StereoRadiance rows =
      OverReadout(kMotion_px, rig, turning, [&](double share) -> StereoRadiance {
        return {UprightEdge(kEdgeAt + share * kMotion_px, 0.0),
                UprightEdge(40.0 + share * kMotion_px, 0.0)};
      });
  for (const int y : {0, 30, 89}) {
    EXPECT_NEAR(EdgeInRow(rows[0], y).mean, kEdgeAt + kMotion_px * TimeOfRow(y), 3e-3);
    EXPECT_NEAR(EdgeInRow(rows[1], y).mean, 40.0 + kMotion_px * TimeOfRow(y), 3e-3);
  }
}

}  // namespace
}  // namespace dockyard
