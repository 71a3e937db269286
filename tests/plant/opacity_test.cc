// Light through the air against published tables and closed forms.
#include "sim/plant/opacity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/plant/sun_motion.h"

namespace dockyard {
namespace {

// Hardie (1962), fitted to Bemporad's table; within 0.1 % up to 6.8.
double Hardie(double elevation_rad) {
  const double s = 1.0 / std::sin(elevation_rad) - 1.0;
  return 1.0 + s - 0.0018167 * s - 0.002875 * s * s - 0.0008083 * s * s * s;
}

TEST(AirMass, IsThatOfTheTableOfBemporad) {
  for (const double elevation_deg : {90.0, 60.0, 45.0, 30.0, 20.0, 12.0, 9.0}) {
    EXPECT_NEAR(AirMass(Radians(elevation_deg)) / Hardie(Radians(elevation_deg)), 1.0, 3e-3)
        << elevation_deg;
  }
  EXPECT_NEAR(AirMass(0.0), 37.92, 0.01) << "Kasten and Young at the horizon";
}

TEST(Opacity, DirectLightFallsByDepthTimesAirMass) {
  for (const double depth : {0.0, 0.3, 2.0}) {
    for (const double elevation_deg : {90.0, 30.0, 5.0}) {
      const double h = Radians(elevation_deg);
      EXPECT_DOUBLE_EQ(LightThroughAir(depth, h).sun, std::exp(-depth * AirMass(h)));
    }
  }
}

TEST(Opacity, WithoutAirAllLightIsTheSuns) {
  EXPECT_EQ(LightThroughAir(0.0, Radians(40.0)).sun, 1.0);
  EXPECT_NEAR(LightThroughAir(0.0, Radians(40.0)).sky, 0.0, 1e-12);
}

// Without absorption: Eddington's solution ((2/3 + m) + (2/3 - m) exp(-t/m)) / (4/3 + (1 - g) t),
// with the forward peak taken out of depth and asymmetry.
TEST(Opacity, TotalBecomesEddingtonsWhereNothingIsAbsorbed) {
  for (const double depth : {0.2, 1.0, 5.0}) {
    for (const double m : {0.2, 0.5, 0.9}) {
      const double g = 0.75, t = (1.0 - g * g) * depth, left = 1.0 - g / (1.0 + g);
      const double wanted =
          ((2.0 / 3.0 + m) + (2.0 / 3.0 - m) * std::exp(-t / m)) / (4.0 / 3.0 + left * t);
      EXPECT_NEAR(TotalTransmission(depth, m, 1.0 - 1e-7, g), wanted, 1e-5);
    }
  }
}

// Where k times the cosine is 1 the closed form is 0 / 0: here at 0.74.
TEST(Opacity, TotalIsSmoothInTheCosine) {
  double before = TotalTransmission(1.0, 0.05, 0.5, 0.75);
  for (double m = 0.0501; m < 1.0; m += 1e-4) {
    const double now = TotalTransmission(1.0, m, 0.5, 0.75);
    ASSERT_LT(std::abs(now - before), 1e-3) << m;
    before = now;
  }
}

// Pollack's net fluxes over an albedo of 0.1 (Appelbaum and Flood, Solar Energy 45, 353 (1990),
// table III), here over 0.9: what comes down. At 0, 40, 60, 70 and 80 deg from the zenith.
TEST(Opacity, TotalIsPollacksAtTheSurfaceOfMars) {
  struct Row {
    double depth, net[5];
  };
  for (const Row& row : {Row{0.1, {0.885, 0.876, 0.857, 0.830, 0.755}},
                         Row{0.5, {0.810, 0.778, 0.708, 0.628, 0.452}},
                         Row{1.0, {0.732, 0.670, 0.560, 0.455, 0.317}},
                         Row{2.0, {0.582, 0.500, 0.378, 0.293, 0.208}},
                         Row{5.0, {0.294, 0.230, 0.166, 0.130, 0.094}}}) {
    int i = 0;
    for (const double zenith_deg : {0.0, 40.0, 60.0, 70.0, 80.0}) {
      const double h = Radians(90.0 - zenith_deg);
      const AirLight air = LightThroughAir(row.depth, h);
      const double total = air.sun + air.sky / std::sin(h);
      EXPECT_NEAR(total, row.net[i++] / 0.9, 0.05) << row.depth << " " << zenith_deg;
    }
  }
}

TEST(Opacity, SkyGrowsWithTheDepthAndTheSumFalls) {
  const double h = Radians(50.0);
  double sky = 0.0, all = 1.0;
  for (const double depth : {0.1, 0.3, 0.6, 1.0}) {
    const AirLight air = LightThroughAir(depth, h);
    EXPECT_GT(air.sky, sky);
    EXPECT_LT(air.sky + air.sun * std::sin(h), all);
    sky = air.sky;
    all = air.sky + air.sun * std::sin(h);
  }
}

SunModel Placed(double elevation_deg, double opacity) {
  SunModel sun;
  sun.azimuth_rad = Radians(180.0);
  sun.elevation_rad = Radians(elevation_deg);
  sun.north_rad = 0.0;
  sun.opacity = opacity;
  return sun;
}

Lighting LightingOf(Light light, const SunModel& sun) {
  return MakeLighting(light, Pose3{}, {0.0, 0.0, 0.5}, 7, sun);
}

TEST(Opacity, SetsTheLightOfEveryKindAndNoneLeavesItAsItWas) {
  const double unset = SunModel{}.opacity;
  EXPECT_EQ(LightingOf(Light::kEven, Placed(30.0, unset)).sun_and_sky.sun_irradiance, 1.0);
  EXPECT_EQ(LightingOf(Light::kEven, Placed(30.0, unset)).sun_and_sky.sky_irradiance, 0.8);
  for (const Light light : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    const SunAndSky lit = LightingOf(light, Placed(30.0, 0.3)).sun_and_sky;
    const AirLight air = LightThroughAir(0.3, Radians(30.0));
    EXPECT_NEAR(lit.sun_irradiance, kOutsideIrradiance * air.sun, 1e-12);
    EXPECT_NEAR(lit.sky_irradiance, kOutsideIrradiance * air.sky, 1e-12);
  }
}

// A clear sky of the Earth has some 0.23.
TEST(Opacity, OfAClearSkyIsAboutTheLightOfHardShadow) {
  const SunAndSky kind =
      LightingOf(Light::kHardShadow, Placed(37.5, SunModel{}.opacity)).sun_and_sky;
  const SunAndSky air = LightingOf(Light::kHardShadow, Placed(37.5, 0.23)).sun_and_sky;
  EXPECT_NEAR(air.sun_irradiance / kind.sun_irradiance, 1.0, 0.1);
  EXPECT_NEAR(air.sky_irradiance / kind.sky_irradiance, 1.0, 0.3);
}

TEST(Opacity, ASunThatMovesFadesToTheLightOfItsHeight) {
  SunModel sun = Placed(90.0 - 34.2, 0.5);  // noon of an equinox
  sun.moving = true;
  Lighting lighting = LightingOf(Light::kEven, sun);
  lighting.sun_and_sky.sun_irradiance *= 0.5;  // a scale of the light's own stays
  lighting.sun_and_sky.sky_irradiance *= 0.5;
  for (const double hours : {2.0, 4.0, 5.5}) {
    const SunAndSky later = LightAt(lighting, 3600.0 * hours);
    const AirLight air = LightThroughAir(0.5, std::asin(later.to_sun_W.z()));
    EXPECT_NEAR(later.sun_irradiance, 0.5 * kOutsideIrradiance * air.sun, 1e-9);
    EXPECT_NEAR(later.sky_irradiance, 0.5 * kOutsideIrradiance * air.sky, 1e-9);
  }
  const SunAndSky night = LightAt(lighting, 3600.0 * 7.0);
  EXPECT_EQ(night.sun_irradiance, 0.0);
  EXPECT_NEAR(night.sky_irradiance,
              0.5 * kOutsideIrradiance * LightThroughAir(0.5, Radians(2.0)).sky, 1e-9);
}

}  // namespace
}  // namespace dockyard
