// The colour camera's sensor against the laws that it states.
#include "render/colour_sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace dockyard {
namespace {

ColourRadiance Even(const Eigen::Vector3d& rgb, int width = 200, int height = 100) {
  ColourRadiance light{.width = width, .height = height};
  for (int c = 0; c < 3; ++c) {
    light.part[c] = {.width = width, .height = height, .values = {}};
    light.part[c].values.assign(static_cast<std::size_t>(width) * height,
                                static_cast<float>(rgb[c]));
  }
  return light;
}

/// Neither optics nor electronics: one electron of radiance 1 is one, ten are a level.
ColourSensorOptions Bare() {
  ColourSensorOptions o;
  o.blur_sigma_px = 0.0;
  o.full_well_e = 2550.0;
  o.fixed_exposure_e = 1.0;
  o.auto_balance = o.halve_colour = o.gamma = false;
  return o;
}

struct Law {
  double mean = 0.0, variance = 0.0;
};
Law LawOf(const RgbImage& image, int channel) {
  Law law;
  const std::size_t count = image.pixels.size() / 3;
  for (std::size_t i = 0; i < count; ++i) law.mean += image.pixels[3 * i + channel];
  law.mean /= static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    law.variance += std::pow(image.pixels[3 * i + channel] - law.mean, 2);
  }
  law.variance /= static_cast<double>(count - 1);
  return law;
}

Eigen::Vector3d MeanOf(const RgbImage& image) {
  return {LawOf(image, 0).mean, LawOf(image, 1).mean, LawOf(image, 2).mean};
}

// The variance of the electrons is their mean and the square of the read noise; rounding to a level
// of 10 electrons adds 1/12 of a level squared.
TEST(ColourNoise, IsShotAndReadNoise) {
  const Eigen::Vector3d light(300.0, 800.0, 1800.0);
  ColourSensorState state;
  const RgbImage image = ExposeColourView(Even(light), Bare(), 0.1, 3, state);
  for (int c = 0; c < 3; ++c) {
    const Law law = LawOf(image, c);
    EXPECT_NEAR(law.mean, light[c] / 10.0, 0.15) << c;
    const double exact = (light[c] + 144.0) / 100.0 + 1.0 / 12.0;
    EXPECT_NEAR(law.variance, exact, 0.04 * exact) << c;  // 1 % by chance
  }
}

TEST(ColourNoise, OfColoursAndPicturesIsIndependent) {
  ColourSensorState state;
  const RgbImage one = ExposeColourView(Even({800, 800, 800}), Bare(), 0.1, 3, state);
  const RgbImage two = ExposeColourView(Even({800, 800, 800}), Bare(), 0.1, 4, state);
  const std::size_t count = one.pixels.size() / 3;
  const auto correlation = [&](auto a, auto b) {
    double sum = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const double u = a(i) - 80.0, v = b(i) - 80.0;
      sum += u * v;
      aa += u * u;
      bb += v * v;
    }
    return sum / std::sqrt(aa * bb);
  };
  const auto of = [](const RgbImage& image, int c, std::size_t on = 0) {
    return [&image, c, on](std::size_t i) { return double(image.pixels[3 * (i + on) + c]); };
  };
  // Of 20000 pixels: 0.007 by chance.
  EXPECT_LT(std::abs(correlation(of(one, 0), of(one, 1))), 0.03);
  EXPECT_LT(std::abs(correlation(of(one, 1), of(one, 2))), 0.03);
  EXPECT_LT(std::abs(correlation(of(one, 0), of(one, 2))), 0.03);
  EXPECT_LT(std::abs(correlation(of(one, 1), of(one, 1, 1))), 0.03);
  EXPECT_LT(std::abs(correlation(of(one, 1), of(two, 1))), 0.03);
}

TEST(ColourNoise, OfFewElectronsWithoutReadNoiseIsPoissons) {
  ColourSensorOptions o = Bare();
  o.full_well_e = 255.0;
  o.read_noise_e = 0.0;
  ColourSensorState state;
  const RgbImage image = ExposeColourView(Even({3, 3, 3}), o, 0.1, 3, state);
  double none = 0.0, three = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    none += image.pixels[i] == 0;
    three += image.pixels[i] == 3;
  }
  EXPECT_NEAR(none / 20000.0, std::exp(-3.0), 0.006);
  EXPECT_NEAR(three / 20000.0, 4.5 * std::exp(-3.0), 0.012);
}

TEST(ColourSensor, HasEqualBitsOnEqualInput) {
  const ColourRadiance light = Even({0.2, 0.3, 0.1});
  ColourSensorState a, b;
  for (std::uint64_t key = 1; key < 4; ++key) {
    EXPECT_EQ(ExposeColourView(light, {}, 0.1, key, a), ExposeColourView(light, {}, 0.1, key, b));
    EXPECT_EQ(a, b);
  }
  ColourSensorState c;
  EXPECT_NE(ExposeColourView(light, {}, 0.1, 1, c), ExposeColourView(light, {}, 0.1, 2, c));
}

// A first-order lag of the logarithm: after t the way that is left is exp(-t / lag).
TEST(ColourExposure, FollowsTheLightWithItsLag) {
  ColourSensorOptions o = Bare();
  o.fixed_exposure_e = 0.0;
  o.exposure_lag_s = 0.4;
  ColourSensorState state;
  ExposeColourView(Even({1, 1, 1}), o, 0.1, 1, state);
  const double first = state.exposure_e;
  EXPECT_NEAR(first, o.target_level * o.full_well_e, 1e-3 * first);  // settled at once
  for (int i = 1; i <= 10; ++i) {
    ExposeColourView(Even({4, 4, 4}), o, 0.1, 1, state);
    const double left = std::log(state.exposure_e / (first / 4.0)) / std::log(4.0);
    EXPECT_NEAR(left, std::exp(-0.1 * i / 0.4), 1e-6) << i;
  }
  o.exposure_lag_s = 0.0;
  ExposeColourView(Even({1, 1, 1}), o, 0.1, 1, state);
  EXPECT_NEAR(state.exposure_e, first, 1e-3 * first);
  ExposeColourView(Even({0, 0, 0}), o, 0.1, 1, state);
  EXPECT_EQ(state.exposure_e, o.most_exposure_e);
}

TEST(ColourExposure, PutsTheLitPartAtItsLevelWhateverIsDark) {
  ColourSensorOptions o = Bare();
  o.fixed_exposure_e = 0.0;
  ColourRadiance light = Even({0.02, 0.02, 0.02}, 60, 60);
  light.width = light.height = 200;
  light.x0 = light.y0 = 70;
  ColourSensorState state;
  const RgbImage image = ExposeColourView(light, o, 0.1, 1, state);
  double sum = 0.0;
  for (int y = 70; y < 130; ++y) {
    for (int x = 70; x < 130; ++x) sum += image.pixels[3 * (200 * y + x) + 1];
  }
  EXPECT_NEAR(sum / 3600.0, 255.0 * o.target_level, 0.5);
  EXPECT_LT(image.pixels[1], 8);  // behind the rim: read noise alone
}

TEST(ColourBalance, MakesTheMeanGreyWithItsLag) {
  ColourSensorOptions o = Bare();
  o.auto_balance = true;
  o.balance_lag_s = 0.5;
  ColourSensorState state;
  const Eigen::Vector3d warm(1500, 1000, 600), cold(800, 1000, 1400);
  const Eigen::Vector3d first = MeanOf(ExposeColourView(Even(warm), o, 0.1, 1, state));
  EXPECT_NEAR(first.x(), first.y(), 0.5);
  EXPECT_NEAR(first.z(), first.y(), 0.5);
  ExposeColourView(Even(cold), o, 0.5, 1, state);
  const double red = std::exp(-1.0) * std::log(1000.0 / 1500.0) +
                     (1.0 - std::exp(-1.0)) * std::log(1000.0 / 800.0);
  EXPECT_NEAR(std::log(state.balance.x()), red, 1e-5);
  o.balance_lag_s = 0.0;  // beyond the range
  ExposeColourView(Even({100, 1000, 100000}), o, 0.5, 1, state);
  EXPECT_NEAR(state.balance.x(), o.most_balance, 1e-9);
  EXPECT_NEAR(state.balance.z(), 1.0 / o.most_balance, 1e-9);
}

// A well is full before the balance: what is brighter loses its hue towards yellow.
TEST(ColourSensor, ClipsEachColourByItself) {
  ColourSensorState state;
  const Eigen::Vector3d orange(2000, 600, 100);
  const Eigen::Vector3d plain = MeanOf(ExposeColourView(Even(orange), Bare(), 0.1, 1, state));
  const Eigen::Vector3d sunny = MeanOf(ExposeColourView(Even(3.0 * orange), Bare(), 0.1, 1, state));
  EXPECT_NEAR(plain.y() / plain.x(), 0.3, 0.01);
  EXPECT_NEAR(sunny.x(), 255.0, 0.1);
  EXPECT_NEAR(sunny.y() / sunny.x(), 1800.0 / 2550.0, 0.01);
}

TEST(ColourSensor, HasTheTransferCurve) {
  ColourSensorOptions o = Bare();
  o.full_well_e = 1e9;  // without noise
  o.gamma = true;
  ColourSensorState state;
  const auto level = [&](double share) {
    o.fixed_exposure_e = 1e9 * share;
    return MeanOf(ExposeColourView(Even({1, 1, 1}, 8, 8), o, 0.1, 1, state)).y();
  };
  // IEC 61966-2-1: 0.2140 is half, 0.0031308 the end of the straight part, at 0.04045.
  EXPECT_NEAR(level(0.21404), 127.5, 0.6);
  EXPECT_NEAR(level(0.0031308), 0.04045 * 255.0, 0.6);
  EXPECT_NEAR(level(1.0), 255.0, 1e-9);
}

// Left red, right blue: the pair across the edge has both pixels' brightness and one colour.
TEST(ColourSensor, PixelsSideBySideShareTheirColour) {
  ColourSensorOptions o = Bare();
  o.full_well_e = 1e9;
  o.fixed_exposure_e = 1e9;
  o.halve_colour = true;
  ColourRadiance light = Even({0.6, 0.2, 0.1}, 16, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 7; x < 16; ++x) {
      light.part[0].values[16 * y + x] = 0.1f;
      light.part[2].values[16 * y + x] = 0.6f;
    }
  }
  ColourSensorState state;
  const RgbImage image = ExposeColourView(light, o, 0.1, 1, state);
  const auto at = [&](int x, int c) { return double(image.pixels[3 * (16 + x) + c]); };
  const auto brightness = [&](int x) {
    return 0.299 * at(x, 0) + 0.587 * at(x, 1) + 0.114 * at(x, 2);
  };
  EXPECT_NEAR(at(5, 0), 153.0, 1.0);  // pairs without an edge keep theirs
  EXPECT_NEAR(at(8, 0), 25.5, 1.0);
  EXPECT_NEAR(at(6, 0) - brightness(6), at(7, 0) - brightness(7), 1.5);
  EXPECT_NEAR(at(6, 2) - brightness(6), at(7, 2) - brightness(7), 1.5);
  EXPECT_NEAR(brightness(6), 255.0 * (0.299 * 0.6 + 0.587 * 0.2 + 0.114 * 0.1), 1.0);
  EXPECT_NEAR(brightness(7), 255.0 * (0.299 * 0.1 + 0.587 * 0.2 + 0.114 * 0.6), 1.0);
}

TEST(ColourSensor, RefusesWhatIsNoSensor) {
  ColourSensorState state;
  const auto take = [&](const ColourSensorOptions& o) {
    return ExposeColourView(Even({1, 1, 1}, 8, 8), o, 0.1, 1, state);
  };
  EXPECT_NO_THROW(take({}));
  EXPECT_THROW(take({.blur_sigma_px = 3.0}), std::invalid_argument);
  EXPECT_DEATH(take({.full_well_e = 0.0}), "check failed");
  EXPECT_DEATH(take({.target_level = 0.0}), "check failed");
  EXPECT_DEATH(take({.exposure_lag_s = -1.0}), "check failed");
  EXPECT_DEATH(take({.balance = {0.0, 1.0, 1.0}}), "check failed");
}

}  // namespace
}  // namespace dockyard
