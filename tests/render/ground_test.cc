// The ground's own shadow and slopes against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "render/ground_horizon.h"
#include "render/ground_mesh.h"
#include "render/ground_relief.h"
#include "render/ground_sectors.h"
#include "render/ground_texture.h"
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

GroundRelief ReliefOf(const Terrace& terrace) {
  GroundRelief relief;
  relief.Update(terrace.scene.ground, terrace.scene.light.to_sun_W, 0.0093);
  return relief;
}

GroundRelief::Cell CellAt(const GroundRelief& relief, double x, double y) {
  return relief.At(static_cast<int>((x + 2.0) / kCell_m), static_cast<int>((y + 2.0) / kCell_m));
}

TEST(Relief, OfAPlaneIsItsSlope) {
  Terrace terrace(0.0, SunAt(0.0, 1.0));
  for (int i = 0; i < kSide * kSide; ++i) {
    terrace.heights[i] = 0.2 * Terrace::X(i % kSide) - 0.1 * Terrace::X(i / kSide);
  }
  const GroundRelief relief = ReliefOf(terrace);
  for (const double x : {-1.99, 0.3, 1.97}) {
    const GroundRelief::Cell cell = CellAt(relief, x, 0.7);
    EXPECT_NEAR(cell.slope_x, 0.2, 1e-5);
    EXPECT_NEAR(cell.slope_y, -0.1, 1e-5);
    EXPECT_EQ(cell.sun_share, 1.0f);
  }
}

TEST(Relief, ShadowOfAStepIsAsLongAsTheSunIsLow) {
  const double elevation = Radians(35.0);
  constexpr double kLow_m = 0.3;
  const Terrace terrace(kLow_m, SunAt(0.0, elevation));
  const GroundRelief relief = ReliefOf(terrace);
  const double end = kAt_m - kLow_m / std::tan(elevation);
  // Penumbra: 0.3 m x 0.0093 rad / sin^2 35 deg = 8 mm, and a cell on either side.
  EXPECT_EQ(CellAt(relief, end + 2.5 * kCell_m, 0.0).sun_share, 0.0f);
  EXPECT_EQ(CellAt(relief, end - 2.5 * kCell_m, 0.0).sun_share, 1.0f);
  EXPECT_EQ(CellAt(relief, kAt_m + 0.1, 0.0).sun_share, 1.0f);
}

// Azimuth and elevation of the sun [deg].
class ChangingRelief : public testing::TestWithParam<std::pair<double, double>> {};

// Waves, and then ruts and heaps anywhere, at the border too: some change how high all the ground
// reaches, and with it how far the shadows are followed.
TEST_P(ChangingRelief, IsThatOfTheGroundMadeAnew) {
  const auto [azimuth_deg, elevation_deg] = GetParam();
  Terrace yard(0.0, SunAt(Radians(azimuth_deg), Radians(elevation_deg)));
  for (int i = 0; i < kSide * kSide; ++i) {
    yard.heights[i] = 0.02 * std::sin(3.0 * Terrace::X(i % kSide) + Terrace::X(i / kSide));
  }
  const GroundView& ground = yard.scene.ground;
  const Eigen::Vector3d& to_sun = yard.scene.light.to_sun_W;
  GroundTexture kept;
  kept.Update(ground, to_sun, 0.0093);
  GroundRelief relief = ReliefOf(yard);
  for (int step = 0; step < 12; ++step) {
    const int column = (step * 71) % (kSide - 3), row = (step * 53 + 190) % (kSide - 3);
    for (int k = 0; k < 9; ++k) {
      yard.heights[(row + k / 3) * kSide + column + k % 3] += step % 3 == 0 ? 0.01 : -0.015;
    }
    const GridRect changed = relief.Update(ground, to_sun, 0.0093);
    EXPECT_TRUE(changed.x_begin <= column && column + 3 <= std::min(changed.x_end + 1, kSide));
    EXPECT_TRUE(relief.Update(ground, to_sun, 0.0093).empty());
    const GroundRelief fresh = ReliefOf(yard);
    kept.Update(ground, to_sun, 0.0093);
    EXPECT_EQ(kept.highest_m(), *std::max_element(yard.heights.begin(), yard.heights.end()));
    for (int i = 0; i < (kSide - 1) * (kSide - 1); ++i) {
      const int x = i % (kSide - 1), y = i / (kSide - 1);
      const GroundRelief::Cell a = relief.At(x, y), b = fresh.At(x, y);
      ASSERT_TRUE(a.slope_x == b.slope_x && a.slope_y == b.slope_y && a.sun_share == b.sun_share)
          << step << ": " << x << ", " << y;
    }
  }
  GroundTexture anew;
  anew.Update(ground, to_sun, 0.0093);
  for (int i = 0; i < (kSide - 1) * (kSide - 1); ++i) {
    const auto x = static_cast<float>(i % (kSide - 1)), y = static_cast<float>(i / (kSide - 1));
    for (float lod = 0.0f; lod < 7.0f; ++lod) {
      const Four a = kept.relief().At(x, y, lod), b = anew.relief().At(x, y, lod);
      ASSERT_EQ(0, std::memcmp(&a, &b, sizeof a)) << x << ", " << y << ", " << lod;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Suns, ChangingRelief,
                         testing::Values(std::pair(20.0, 8.0), std::pair(200.0, 25.0),
                                         std::pair(-70.0, 60.0), std::pair(0.0, 90.0)));

TEST(Relief, OfALittleRutIsMadeAnewThereAlone) {
  Terrace yard(0.3, SunAt(0.0, Radians(45.0)));
  GroundRelief relief = ReliefOf(yard);
  yard.heights[50 * kSide + 80] = 0.01;
  // 15 nodes on the ray up to 0.3 m towards the sun.
  const GridRect changed = relief.Update(yard.scene.ground, yard.scene.light.to_sun_W, 0.0093);
  EXPECT_EQ(changed.x_end, 81);
  EXPECT_NEAR(changed.x_begin, 80 - 16, 1);
  EXPECT_EQ(changed.y_begin, 49);
  EXPECT_EQ(changed.y_end, 51);
}

// A spectator's view from beyond the fan's pole: points of one view on each side of the pole have
// all azimuths about it.
TEST(GroundSectors, AreAllForAViewThatShowsTheFansPole) {
  const TanRect rect{-0.6, -0.35, 0.6, 0.35};
  for (const double turn : {0.0, 0.7, 2.5, -1.9}) {
    // 0.6 m off the pole and 0.5 m up, pitched down at it: right, down, ahead.
    Eigen::Matrix3d ahead;
    ahead << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    const Pose3 X_FC{RotZ(turn) * RotY(std::atan2(0.5, 0.6)) * ahead,
                     RotZ(turn) * Eigen::Vector3d(-0.6, 0.0, 0.5)};
    EXPECT_EQ(VisibleSectors(X_FC, rect).count, kGroundSectors);
    const Pose3 over_it{RotZ(turn) * ahead, {0.0, 0.0, 0.3}};
    EXPECT_LT(VisibleSectors(over_it, rect).count, kGroundSectors / 2);
  }
}

}  // namespace
}  // namespace dockyard
