// The ground's own shadow and slopes against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/ground_horizon.h"
#include "render/ground_mesh.h"
#include "render/scene_samples.h"

namespace dockyard {
namespace {

constexpr double kCell_m = 0.02;
constexpr int kSide = 201;  // x and y from -2 to 2
constexpr double kStep_m = 1.2, kAt_m = 1.0;

// Level at 0; from x = 1 on, if wanted, a terrace. The step between is one cell wide.
struct Terrace {
  explicit Terrace(double step_m, const Eigen::Vector3d& to_sun) : heights(kSide * kSide, 0.0) {
    for (int i = 0; i < kSide * kSide; ++i) {
      if (X(i % kSide) > kAt_m - 1e-9) heights[i] = step_m;
    }
    scene.ground = {.X_WG = {},
                    .x0_m = -2.0,
                    .y0_m = -2.0,
                    .cell_m = kCell_m,
                    .nx = kSide,
                    .ny = kSide,
                    .heights_m = heights.data()};
    scene.light.to_sun_W = to_sun;
  }
  Terrace(const Terrace&) = delete;
  Terrace& operator=(const Terrace&) = delete;
  static double X(int ix) { return -2.0 + kCell_m * ix; }
  double Share(double x, double z) const {
    return GroundHorizon(scene, *std::max_element(heights.begin(), heights.end()))
        .Share(Eigen::Vector3d(x, 0.0, z).cast<float>());
  }

  std::vector<double> heights;
  Scene scene;
};

// Share of a disc above a level line s radii over its middle.
double DiscAbove(double s) {
  if (s >= 1.0) return 0.0;
  if (s <= -1.0) return 1.0;
  return 0.5 - (s * std::sqrt(1.0 - s * s) + std::asin(s)) / kPi;
}

class Horizon : public testing::TestWithParam<double> {};

// A strip as wide as the disc covers at most 0.057 more or less of it than the disc itself.
TEST_P(Horizon, OfAStepLeavesTheShareOfTheDiscAboveItsEdge) {
  const double elevation = Radians(GetParam());
  const Terrace terrace(kStep_m, SunAt(0.0, elevation));
  const double radius = 0.5 * terrace.scene.light.sun_angular_diameter_rad;
  for (const double x : {0.3, 0.6, 0.8}) {
    double last = -1.0;
    for (double s = -1.5; s <= 1.5; s += 0.25) {
      // The height from which the edge stands s radii over the sun's middle.
      const double z = kStep_m - (kAt_m - x) * std::tan(elevation + s * radius);
      const double share = terrace.Share(x, z);
      EXPECT_NEAR(share, DiscAbove(s), 0.07) << "x " << x << ", s " << s;
      if (s < -1.1) {
        EXPECT_EQ(share, 1.0);
      }
      if (s > 1.1) {
        EXPECT_EQ(share, 0.0);
      }
      EXPECT_TRUE(last < 0.0 || share <= last);
      last = share;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Elevations, Horizon, testing::Values(10.0, 20.0, 35.0, 55.0));

TEST(Horizon, SeenObliquelyIsAsFarAwayAsTheRayGoes) {
  const double azimuth = Radians(40.0), elevation = Radians(20.0);
  const Terrace terrace(kStep_m, SunAt(azimuth, elevation));
  const double way = 0.5 / std::cos(azimuth);  // to the step
  const double edge = kStep_m - way * std::tan(elevation);
  EXPECT_EQ(terrace.Share(0.5, edge + 0.02), 1.0);
  EXPECT_EQ(terrace.Share(0.5, edge - 0.02), 0.0);
}

TEST(Horizon, OfLevelGroundHidesNothing) {
  EXPECT_EQ(Terrace(0.0, SunAt(0.3, Radians(5.0))).Share(0.0, 0.05), 1.0);
}

TEST(Horizon, ASunAtTheZenithIsAlwaysSeen) {
  EXPECT_EQ(Terrace(kStep_m, {0, 0, 1}).Share(0.99, 0.0), 1.0);
}

TEST(Horizon, BehindTheBackHidesNothing) {
  EXPECT_EQ(Terrace(kStep_m, SunAt(kPi, Radians(10.0))).Share(0.9, 0.0), 1.0);
}

TEST(Horizon, EndsWithTheGrid) {
  EXPECT_EQ(Terrace(kStep_m, SunAt(0.0, Radians(5.0))).Share(-2.5, 0.0), 1.0);
}

// Per cell: slope along x and y, share of the sun.
std::array<float, 3> ReliefAt(const std::vector<float>& relief, double x, double y) {
  const int ix = static_cast<int>((x + 2.0) / kCell_m), iy = static_cast<int>((y + 2.0) / kCell_m);
  const std::size_t at = 3 * (static_cast<std::size_t>(iy) * (kSide - 1) + ix);
  return {relief[at], relief[at + 1], relief[at + 2]};
}

TEST(Relief, OfAPlaneIsItsSlope) {
  Terrace terrace(0.0, SunAt(0.0, 1.0));
  for (int i = 0; i < kSide * kSide; ++i) {
    terrace.heights[i] = 0.2 * Terrace::X(i % kSide) - 0.1 * Terrace::X(i / kSide);
  }
  const auto relief = GroundRelief(terrace.scene.ground, terrace.scene.light.to_sun_W, 0.0093);
  ASSERT_EQ(relief.size(), 3u * (kSide - 1) * (kSide - 1));
  for (const double x : {-1.99, 0.3, 1.97}) {
    const auto [slope_x, slope_y, share] = ReliefAt(relief, x, 0.7);
    EXPECT_NEAR(slope_x, 0.2, 1e-5);
    EXPECT_NEAR(slope_y, -0.1, 1e-5);
    EXPECT_EQ(share, 1.0f);
  }
}

TEST(Relief, ShadowOfAStepIsAsLongAsTheSunIsLow) {
  const double elevation = Radians(35.0);
  constexpr double kLow_m = 0.3;
  const Terrace terrace(kLow_m, SunAt(0.0, elevation));
  const auto relief = GroundRelief(terrace.scene.ground, terrace.scene.light.to_sun_W, 0.0093);
  const double end = kAt_m - kLow_m / std::tan(elevation);
  // Penumbra: 0.3 m x 0.0093 rad / sin^2 35 deg = 8 mm, and a cell on either side.
  EXPECT_EQ(ReliefAt(relief, end + 2.5 * kCell_m, 0.0)[2], 0.0f);
  EXPECT_EQ(ReliefAt(relief, end - 2.5 * kCell_m, 0.0)[2], 1.0f);
  EXPECT_EQ(ReliefAt(relief, kAt_m + 0.1, 0.0)[2], 1.0f);
}

}  // namespace
}  // namespace dockyard
