// The shadow map by hand: a tilted plane, a plate above part of it.
#include "render/sun_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "render/pixel_noise.h"

namespace dockyard {
namespace {

ShadowFit TwoWindows() {
  ShadowFit fit{.X_WU = {}, .coarse = {}, .fine = {}, .top_m = 3.0, .bottom_m = -1.0};
  fit.coarse = {.half_m = 4.0, .texels = kCoarseTexels};
  fit.fine = {.half_m = 0.6, .texels = kFineTexels, .column = kCoarseTexels};
  return fit;
}

// Casters of these heights above each place.
template <class HeightAt>
void FillDepths(const ShadowFit& fit, const HeightAt& height_at, SunShadow& shadow) {
  for (const ShadowWindow& window : {fit.coarse, fit.fine}) {
    for (int row = 0; row < window.texels; ++row) {
      for (int column = 0; column < window.texels; ++column) {
        const double x = (column + 0.5) * window.texel_m() - window.half_m;
        const double y = (row + 0.5) * window.texel_m() - window.half_m;
        const double z = height_at(x, y);
        shadow.depth()[static_cast<std::size_t>(row) * kAtlasWidth + window.column + column] =
            static_cast<float>((fit.top_m - z) / (fit.top_m - fit.bottom_m));
      }
    }
  }
}

TEST(SunShadow, BoundsOverAPlaneChangeNoShare) {
  const ShadowFit fit = TwoWindows();
  const Eigen::Vector3d normal = Eigen::Vector3d(0.4, -0.2, 0.8).normalized();
  const auto plane_z = [&](double x, double y) {
    return 0.1 - (normal.x() * x + normal.y() * y) / normal.z();
  };
  SunShadow shadow;
  FillDepths(
      fit, [&](double x, double y) { return x > 0.1 && y > -0.2 ? 2.0 : plane_z(x, y); }, shadow);
  shadow.Take(fit, 0.0093);
  shadow.TakePlane({0.0, 0.0, plane_z(0.0, 0.0)}, normal);
  int sunlit = 0, penumbra = 0, spared = 0;
  for (int i = 0; i < 90; ++i) {
    for (int j = 0; j < 90; ++j) {
      const double x = 0.012 * (i - 45) + 0.0007 * j, y = 0.012 * (j - 45);
      SunShadow::Place place{
          .p = Eigen::Vector3d(x, y, plane_z(x, y)).cast<float>(),
          .slopes = SunShadow::SlopesOf(normal.cast<float>()),
          .bias_m = 0.001f,
          .blur_m = 0.001f,
          .pixel_x = i,
          .pixel_y = j,
      };
      const float by_points = shadow.Share(place, 8, 16);
      const bool points_needed = shadow.Plain(place) < 0.0f;
      for (const bool in_plane : {false, true}) {  // many places at once as one alone
        place.in_plane = in_plane;
        float many[2] = {2.0f, 2.0f};
        const std::array<float, 2> x{0.0f, place.p.x()}, y{0.0f, place.p.y()}, z{9.0f, place.p.z()};
        const std::array<float, 2> slope_x{0.0f, place.slopes.x}, slope_y{0.0f, place.slopes.y};
        shadow.PlainOf({x.data(), y.data(), z.data(), slope_x.data(), slope_y.data()}, 2,
                       place.bias_m, in_plane, many);
        ASSERT_EQ(many[0], 1.0f);
        ASSERT_EQ(many[1], shadow.Plain(place));
      }
      place.in_plane = true;
      ASSERT_EQ(shadow.Share(place, 8, 16), by_points);
      sunlit += by_points == 1.0f;
      penumbra += by_points > 0.0f && by_points < 1.0f;
      spared += points_needed && shadow.Plain(place) >= 0.0f;
    }
  }
  EXPECT_GT(sunlit, 3000);
  EXPECT_GT(penumbra, 100);
  EXPECT_GT(spared, 0.8 * sunlit);
}

// A surface that had another slope before goes by points alone.
TEST(SunShadow, BlocksOfTexelsChangeNoShare) {
  const ShadowFit fit = TwoWindows();
  const Eigen::Vector3d normal = Eigen::Vector3d(0.5, -0.6, 0.4).normalized();
  const auto plane_z = [&](double x, double y) {
    return 0.1 - (normal.x() * x + normal.y() * y) / normal.z();
  };
  SunShadow shadow;
  FillDepths(
      fit,
      [&](double x, double y) { return x > 0.1 && y > -0.2 ? plane_z(x, y) + 0.3 : plane_z(x, y); },
      shadow);
  shadow.Take(fit, 0.0093);
  const SunShadow::Place elsewhere{.p = {0, 0, 0},
                                   .slopes = {0.1f, 0.1f},
                                   .bias_m = 0.003f,
                                   .blur_m = 0.001f,
                                   .pixel_x = 0,
                                   .pixel_y = 0};
  int spared = 0, dark = 0, partly = 0;
  for (int i = 0; i < 90; ++i) {
    for (int j = 0; j < 90; ++j) {
      const double x = 0.02 * (i - 45) + 0.0007 * j, y = 0.02 * (j - 45);
      const SunShadow::Place place{.p = Eigen::Vector3d(x, y, plane_z(x, y)).cast<float>(),
                                   .slopes = SunShadow::SlopesOf(normal.cast<float>()),
                                   .bias_m = 0.003f,
                                   .blur_m = 0.001f,
                                   .pixel_x = i,
                                   .pixel_y = j};
      shadow.Partly(elsewhere, 4, 8);
      const float by_points = shadow.Partly(place, 4, 8);
      ASSERT_EQ(shadow.Partly(place, 4, 8), by_points);
      float many[2] = {2.0f, 2.0f};
      const std::array<float, 2> p_x{place.p.x(), place.p.x()}, p_y{place.p.y(), place.p.y()};
      const std::array<float, 2> p_z{place.p.z(), place.p.z()}, blur{place.blur_m, place.blur_m};
      const std::array<float, 2> slope_x{place.slopes.x, place.slopes.x};
      const std::array<float, 2> slope_y{place.slopes.y, place.slopes.y};
      shadow.PlainOf(
          {p_x.data(), p_y.data(), p_z.data(), slope_x.data(), slope_y.data(), blur.data()}, 2,
          place.bias_m, false, many);
      if (many[1] >= 0.0f) {
        ASSERT_EQ(many[1], by_points);
      }
      spared += many[1] >= 0.0f && shadow.Plain(place) < 0.0f;
      dark += by_points == 0.0f;
      partly += by_points > 0.0f && by_points < 1.0f;
    }
  }
  EXPECT_GT(spared, 6000);
  EXPECT_GT(dark, 1000);
  EXPECT_GT(partly, 20);
}

// Of a map without order, against each texel by itself.
TEST(ShadowBlocks, BoundAllTexelsOfABlockAndItsMargin) {
  constexpr int kWide = 40, kHigh = 30;
  std::vector<float> depth;
  for (int i = 0; i < kWide * kHigh; ++i) {
    const auto drawn = static_cast<float>(HashUniform(7, static_cast<std::uint64_t>(i)));
    depth.push_back(drawn > 0.97f ? 1.0f : drawn);
  }
  ShadowBlocks blocks;
  for (const ShadowBlocks::Rises& rises : {ShadowBlocks::Rises{0.02f, -0.03f}, {0.5f, 0.25f}}) {
    for (int again = 0; again < 2; ++again) {
      for (int row = 4; row + 6 <= kHigh; row += 4) {
        for (int column = 4; column + 6 <= kWide; column += 4) {
          double lowest = 1e12, highest = -1e12;
          for (int y = row - 2; y < row + 6; ++y) {
            for (int x = column - 2; x < column + 6; ++x) {
              const float d = depth[static_cast<std::size_t>(y * kWide + x)];
              const double caster = d < 1.0f ? 3.0 - 2.0 * d : ShadowBlocks::kNoCaster;
              const double over = caster - rises.x * (x + 0.5 - column) - rises.y * (y + 0.5 - row);
              lowest = std::min(lowest, over);
              highest = std::max(highest, over);
            }
          }
          const auto bounds = blocks.Over({depth.data(), kWide, 3.0f, 2.0f}, column, row, rises);
          ASSERT_NEAR(bounds.lowest, lowest, std::max(1e-5, 1e-6 * std::abs(lowest)));
          ASSERT_NEAR(bounds.highest, highest, 1e-5);
        }
      }
    }
  }
}

}  // namespace
}  // namespace dockyard
