// The exposure that the image before sets, against the rule on that image.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render/exposure_rule.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

/// An image of random radiances whose mean is `level`.
RadianceImage LightOf(double level, std::uint64_t key) {
  RadianceImage image{.width = 40, .height = 30, .values = {}};
  for (std::size_t i = 0; i < 40 * 30; ++i) {
    image.values.push_back(static_cast<float>(2.0 * level * HashUniform(key, i)));
  }
  return image;
}

double ByItself(const RadianceImage& image, const SensorOptions& sensor = {}) {
  return ElectronsOfRadiance({&image, 1}, sensor);
}

TEST(ExposureBefore, IsThatOfTheRuleOnTheImageBeforeAndTheFirstIsItsOwn) {
  KeptExposure kept;
  double before = 0.0;
  for (int k = 0; k < 6; ++k) {
    const RadianceImage image = LightOf(std::exp2(k % 3), static_cast<std::uint64_t>(k));
    const double given = ElectronsOfRadiance({&image, 1}, {}, &kept);
    EXPECT_EQ(given, k == 0 ? ByItself(image) : before) << k;
    EXPECT_NE(given, k == 0 ? 0.0 : ByItself(image)) << k;
    before = ByItself(image);
  }
}

TEST(ExposureBefore, StopsAreOffTheRulesChoiceAndDoNotChangeTheNextOne) {
  KeptExposure kept;
  const RadianceImage first = LightOf(1.0, 1), second = LightOf(3.0, 2), third = LightOf(0.5, 3);
  ElectronsOfRadiance({&first, 1}, {}, &kept);
  const SensorOptions brighter{.exposure_stops = 2.0};
  EXPECT_EQ(ElectronsOfRadiance({&second, 1}, brighter, &kept), 4.0 * ByItself(first));
  EXPECT_EQ(ElectronsOfRadiance({&third, 1}, {}, &kept), ByItself(second));
}

TEST(ExposureBefore, ImagesWithoutPixelsLeaveIt) {
  KeptExposure kept;
  const RadianceImage first = LightOf(1.0, 1), none;
  ElectronsOfRadiance({&none, 1}, {}, &kept);
  EXPECT_EQ(ElectronsOfRadiance({&first, 1}, {}, &kept), ByItself(first));
  ElectronsOfRadiance({&none, 1}, {}, &kept);
  EXPECT_EQ(ElectronsOfRadiance({&none, 1}, {}, &kept), ByItself(first));
}

TEST(ExposureBefore, OfAPairTheCameraWithAnImageSetsIt) {
  KeptExposure kept;
  const std::vector<RadianceImage> pair{RadianceImage{}, LightOf(2.0, 4)};
  ElectronsOfRadiance(pair, {}, &kept);
  EXPECT_EQ(kept.electrons, ByItself(pair[1]));
}

TEST(ExposureBefore, AFixedExposureIsFixed) {
  KeptExposure kept;
  const RadianceImage first = LightOf(1.0, 1), second = LightOf(3.0, 2);
  const SensorOptions fixed{.fixed_exposure_e = 700.0, .exposure_stops = 1.0};
  for (const RadianceImage& image : {first, second}) {
    EXPECT_EQ(ElectronsOfRadiance({&image, 1}, fixed, &kept), 1400.0);
  }
  EXPECT_EQ(kept.electrons, 0.0);
}

}  // namespace
}  // namespace dockyard
