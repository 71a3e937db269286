// The renderer against rays through the same scene (Embree).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "render/measure.h"
#include "render/ray_caster.h"

namespace dockyard {
namespace {

struct Difference {
  double mean = 0.0, beyond_8 = 0.0;  // grey levels; share of the pixels
};

// Grey levels as the sensor would count them: 5 % of the pixels above 0.49 of 255.
Difference Compare(const RadianceImage& a, const RadianceImage& b) {
  std::vector<float> sorted(b.values);
  std::sort(sorted.begin(), sorted.end());
  const double level = 0.49 * 255.0 / sorted[sorted.size() * 95 / 100];
  Difference d;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double off = level * std::abs(a.values[i] - b.values[i]);
    d.mean += off / static_cast<double>(a.values.size());
    d.beyond_8 += (off > 8.0) / static_cast<double>(a.values.size());
  }
  return d;
}

class Rays : public testing::TestWithParam<double> {};

// Mean and share of the left picture's pixels, at a range from the station.
Difference DrawnAgainstCast(double range_m, const StereoRig& rig, int rays_a_side = 5) {
  auto yard = SampleYard(range_m, SunAt(0.7, 0.7));
  yard->scene.ground.texture_seed = 0;  // no grain
  AddCanopy(*yard);
  const RadianceImage drawn = StereoRenderer().RenderRadiance(yard->scene, rig, yard->X_WR)[0];
  const RadianceImage cast = CastRays(yard->scene, rig.left, yard->X_WR * rig.X_RL, rays_a_side);
  const Difference d = Compare(drawn, cast);
  std::printf("%.1f m: mean %.3f grey levels, %.3f %% of the pixels off by more than 8\n", range_m,
              d.mean, 100.0 * d.beyond_8);
  if (const char* folder = std::getenv("DOCKYARD_IMAGES")) {
    for (const auto& [name, image] : {std::pair("drawn", &drawn), {"cast", &cast}}) {
      char path[300];
      std::snprintf(path, sizeof path, "%s/%s_%.0f.pgm", folder, name, range_m);
      if (FILE* file = std::fopen(path, "wb")) {
        std::fprintf(file, "P5 %d %d 255\n", image->width, image->height);
        for (const float v : image->values) {
          std::fputc(static_cast<int>(std::min(255.0f, 700.0f * v)), file);
        }
        std::fclose(file);
      }
    }
  }
  return d;
}

TEST_P(Rays, SeeWhatTheRendererDraws) {
  const Difference d = DrawnAgainstCast(GetParam(), SampleRig(320, 240));
  EXPECT_LT(d.mean, 1.0);
  EXPECT_LT(d.beyond_8, 0.03);
}

// Corners 64.4 deg off the axis, as of Rocky 7's body pair.
TEST(WideRays, SeeWhatTheRendererDraws) {
  StereoRig rig = SampleRig(640, 480);
  rig.left = rig.right = EquidistantCamera(640, 480, Radians(103.0));
  const Difference d = DrawnAgainstCast(2.0, rig, 3);
  EXPECT_LT(d.mean, 1.0);
  EXPECT_LT(d.beyond_8, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Ranges, Rays, testing::Values(1.5, 2.0, 4.0, 6.0));

}  // namespace
}  // namespace dockyard
