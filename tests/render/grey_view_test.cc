// A single grey view against the left one of a pair.
#include <gtest/gtest.h>

#include <cmath>

#include "render/kept_sensor.h"
#include "render/measure.h"
#include "render/scene_samples.h"
#include "render/shutter.h"

namespace dockyard {
namespace {

/// A pair whose left camera is its body's own frame.
StereoRig PairOf(const Camera& camera) {
  return {camera, camera, {}, Pose3::Translation(0.2, 0.0, 0.0)};
}

Pose3 InYard(const Yard& yard) { return yard.X_WR * ForwardCamera(0.05, 0.1, 0.25, 0.1); }

TEST(GreyView, OfAWideImageIsTheLeftOneOfAPairToTheBit) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const Camera camera = EquidistantCamera(1280, 160, kPi / 2);
  const Pose3 X_WC = InYard(*yard);
  StereoRenderer renderer;
  const RadianceImage left = renderer.RenderRadiance(yard->scene, PairOf(camera), X_WC, true)[0];
  const RadianceImage alone = renderer.RenderGrey(yard->scene, camera, X_WC, true);
  EXPECT_EQ(alone.values, left.values);
  EXPECT_EQ(alone.inverse_depth, left.inverse_depth);
}

// A floor as a plane and as triangles, and shadows of a coarser map: their edges alone differ.
TEST(GreyView, OfASmallImageOnALevelFloorDiffersAtShadowsEdgesAlone) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  for (double& height : yard->heights_m) height = 0.0;
  const Camera camera = EquidistantCamera(320, 240, kPi / 2);
  const Pose3 X_WC = InYard(*yard);
  StereoRenderer renderer;
  for (const double sun : {0.0, 1.0}) {
    yard->scene.light.sun_irradiance = sun;
    const RadianceImage left = renderer.RenderRadiance(yard->scene, PairOf(camera), X_WC)[0];
    const RadianceImage alone = renderer.RenderGrey(yard->scene, camera, X_WC);
    int off = 0;
    for (std::size_t i = 0; i < left.values.size(); ++i) {
      off += std::abs(alone.values[i] - left.values[i]) > 0.01f * left.values[i];
    }
    EXPECT_LT(off, (sun > 0.0 ? 0.03 : 0.001) * static_cast<double>(left.values.size())) << sun;
  }
}

TEST(GreyView, DoesNotDependOnTheCamerasDrawnBefore) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const Pose3 X_WC = InYard(*yard);
  StereoRenderer renderer;
  const Camera camera = EquidistantCamera(160, 120, kPi / 2);
  const RadianceImage first = renderer.RenderGrey(yard->scene, camera, X_WC);
  for (int width = 100; width < 130; width += 2) {  // more cameras than are kept
    renderer.RenderGrey(yard->scene, EquidistantCamera(width, 60, 1.0), X_WC);
  }
  EXPECT_EQ(renderer.RenderGrey(yard->scene, camera, X_WC).values, first.values);
}

// By the quantile of one image or of two equal ones, and with a fixed exposure.
TEST(GreyView, IsExposedAsTheLeftOneOfAPairOfEqualViews) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const Camera camera = EquidistantCamera(161, 119, kPi / 2);
  const RadianceImage light = StereoRenderer().RenderGrey(yard->scene, camera, InYard(*yard), true);
  for (const double fixed_e : {0.0, 30000.0}) {
    SensorOptions sensor{.response_sigma = 0.01,
                         .bits = 12,
                         .vignetting_exponent = 2.0,
                         .blur_sigma_px = 0.6,
                         .fixed_exposure_e = fixed_e,
                         .noise_key = 5,
                         .pattern_key = 6};
    sensor.windows[0] = {.distance_m = 0.01, .pupil_m = 0.002, .cover_share = 0.1};
    sensor.windows[1] = sensor.windows[0];
    const auto pair = ExposeDeep({light, light}, PairOf(camera), sensor);
    EXPECT_EQ(ExposeOne(light, camera, sensor), pair[0]);
    EXPECT_EQ(ExposeGrey(light, camera, sensor),
              ExposeStereo({light, light}, PairOf(camera), sensor).left);
  }
}

TEST(GreyView, DoesNotDependOnWhatASensorKeeps) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const Camera camera = EquidistantCamera(161, 119, kPi / 2);
  const Camera other = EquidistantCamera(161, 119, 1.2);
  const RadianceImage light = StereoRenderer().RenderGrey(yard->scene, camera, InYard(*yard));
  SensorOptions sensor{.response_sigma = 0.01, .vignetting_exponent = 2.0, .pattern_key = 6};
  KeptSensor kept;
  const auto expect_same = [&](const Camera& with) {
    for (int image = 0; image < 2; ++image) {
      ++sensor.noise_key;
      EXPECT_EQ(ExposeGrey(light, with, sensor, kept), ExposeGrey(light, with, sensor));
    }
  };
  expect_same(camera);
  expect_same(other);
  sensor.vignetting_exponent = 0.0;
  expect_same(other);
  sensor.pattern_key = 7;
  expect_same(other);
  sensor.response_sigma = 0.1;
  expect_same(other);
  sensor.response_sigma = 0.0;
  expect_same(other);
}

TEST(GreyView, OverAnExposureIsTheLeftOneOfThePair) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const Camera camera = EquidistantCamera(160, 120, kPi / 2);
  const Pose3 X_WC = InYard(*yard);
  StereoRenderer renderer;
  const ExposureMotion motion{{0.004, 0.001, 0.01}, {0.001, 0.01, -0.002}};
  const auto at = [&](double share) {
    Pose3 X = X_WC;
    X.p += X.R * (share * motion.shift_m);
    return X;
  };
  for (const double motion_px : {0.0, 0.6, 2.0}) {
    const auto pair =
        OverExposure(motion_px, PairOf(camera), motion, [&](double share, bool depth) {
          const RadianceImage view = renderer.RenderGrey(yard->scene, camera, at(share), depth);
          return StereoRadiance{view, view};
        });
    const RadianceImage one =
        OverExposure(motion_px, camera, motion, [&](double share, bool depth) {
          return renderer.RenderGrey(yard->scene, camera, at(share), depth);
        });
    EXPECT_EQ(one.values, pair[0].values) << motion_px;
  }
}

}  // namespace
}  // namespace dockyard
