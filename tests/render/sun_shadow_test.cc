// The shadow map by hand: a tilted plane, a plate above part of it.
#include "render/sun_shadow.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace dockyard {
namespace {

TEST(SunShadow, BoundsOverAPlaneChangeNoShare) {
  ShadowFit fit{.X_WU = {}, .coarse = {}, .fine = {}, .top_m = 3.0, .bottom_m = -1.0};
  fit.coarse = {.half_m = 4.0, .texels = kCoarseTexels};
  fit.fine = {.half_m = 0.6, .texels = kFineTexels, .column = kCoarseTexels};
  const Eigen::Vector3d normal = Eigen::Vector3d(0.4, -0.2, 0.8).normalized();
  const auto plane_z = [&](double x, double y) {
    return 0.1 - (normal.x() * x + normal.y() * y) / normal.z();
  };
  SunShadow shadow;
  for (const ShadowWindow& window : {fit.coarse, fit.fine}) {
    for (int row = 0; row < window.texels; ++row) {
      for (int column = 0; column < window.texels; ++column) {
        const double x = (column + 0.5) * window.texel_m() - window.half_m;
        const double y = (row + 0.5) * window.texel_m() - window.half_m;
        const double z = x > 0.1 && y > -0.2 ? 2.0 : plane_z(x, y);
        shadow.depth()[static_cast<std::size_t>(row) * kAtlasWidth + window.column + column] =
            static_cast<float>((fit.top_m - z) / (fit.top_m - fit.bottom_m));
      }
    }
  }
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

}  // namespace
}  // namespace dockyard
