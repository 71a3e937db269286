// The light of a moment of a run.
#include "sim/plant/sun_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/sun_date.h"
#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

SunModel Placed(bool moving) {
  SunModel sun;
  sun.azimuth_rad = Radians(20.0);
  sun.elevation_rad = Radians(50.0);
  sun.moving = moving;
  return sun;
}

/// About a dock at a place and with a turn of its own, on a slope.
const Pose3 kX_WD{RotZ(0.7) * RotY(0.1), {3.0, -2.0, 0.5}};

Lighting LightingOf(bool moving, Light light = Light::kEven) {
  return MakeLighting(light, kX_WD, {0.0, 0.0, 0.5}, 7, Placed(moving));
}

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(SunMotion, OfASunThatStaysTheLightIsThatOfTheStart) {
  const Lighting lighting = LightingOf(false);
  EXPECT_FALSE(lighting.to_pole_W.has_value());
  EXPECT_EQ(LightAt(lighting, 5e4).to_sun_W, lighting.sun_and_sky.to_sun_W);
}

TEST(SunMotion, BeginsWhereASunThatStaysIs) {
  for (const Light light : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    const Lighting still = LightingOf(false, light), moving = LightingOf(true, light);
    EXPECT_EQ(LightAt(moving, 0.0).to_sun_W, still.sun_and_sky.to_sun_W);
    ASSERT_EQ(moving.occluders.size(), still.occluders.size());
    for (std::size_t i = 0; i < still.occluders.size(); ++i) {
      EXPECT_EQ(moving.occluders[i].X_WO.p, still.occluders[i].X_WO.p);
    }
  }
}

// At noon the declination is the elevation less the complement of the latitude.
TEST(SunMotion, IsTheSkysAboutADockThatIsTurnedOnASlope) {
  const Lighting lighting = LightingOf(true);
  const Eigen::Vector3d start = lighting.sun_and_sky.to_sun_W;
  const double declination = Radians(50.0 - (90.0 - 34.2)), latitude = Radians(34.2);
  const double to_sun_rad = std::atan2(start.y(), start.x());
  for (const double hours : {0.5, 2.0}) {
    const Eigen::Vector3d later = LightAt(lighting, 3600.0 * hours).to_sun_W;
    const double turn = Radians(15.0 * hours);
    EXPECT_NEAR(AngleBetween(start, later),
                2.0 * std::asin(std::cos(declination) * std::sin(0.5 * turn)), 1e-9);
    EXPECT_NEAR(later.z(),
                std::sin(latitude) * std::sin(declination) +
                    std::cos(latitude) * std::cos(declination) * std::cos(turn),
                1e-9);
    EXPECT_LT(std::remainder(std::atan2(later.y(), later.x()) - to_sun_rad, 2.0 * kPi), 0.0);
  }
}

TEST(SunMotion, TheLightOfTenSecondsIsOfTheirBeginningAndLessThanATenthOfTheSunOff) {
  const Lighting lighting = LightingOf(true);
  EXPECT_EQ(LightAt(lighting, 9.9).to_sun_W, LightAt(lighting, 0.0).to_sun_W);
  EXPECT_EQ(LightAt(lighting, 600.0).to_sun_W, LightAt(lighting, 609.9).to_sun_W);
  const double step =
      AngleBetween(LightAt(lighting, 600.0).to_sun_W, LightAt(lighting, 610.0).to_sun_W);
  EXPECT_GT(step, 0.0);
  EXPECT_LT(step, 0.1 * lighting.sun_and_sky.sun_angular_diameter_rad);
}

TEST(SunMotion, ASunThatHasSetGivesNoLight) {
  const Lighting lighting = LightingOf(true);
  const SunAndSky day = LightAt(lighting, 3.0 * 3600.0), night = LightAt(lighting, 8.0 * 3600.0);
  EXPECT_EQ(day.sun_irradiance, lighting.sun_and_sky.sun_irradiance);
  EXPECT_EQ(night.sun_irradiance, 0.0);
  EXPECT_NEAR(night.to_sun_W.norm(), 1.0, 1e-9);
  EXPECT_EQ(night.sky_irradiance, lighting.sun_and_sky.sky_irradiance);
}

TEST(SunMotion, BeginsWhereDateAndHourPlaceTheSun) {
  SunModel sun;
  sun.date = "04-10";
  sun.hour = 15.5;
  sun.north_rad = Radians(50.0);
  const SunModel placed = PlacedByDate(sun);
  const Eigen::Vector3d to_sun_W =
      MakeLighting(Light::kEven, kX_WD, {0.0, 0.0, 0.5}, 7, sun).sun_and_sky.to_sun_W;
  EXPECT_NEAR(std::asin(to_sun_W.z()), placed.elevation_rad, 1e-9);
  const double heading_rad = std::atan2(kX_WD.R(1, 0), kX_WD.R(0, 0));
  const double azimuth_rad = std::atan2(to_sun_W.y(), to_sun_W.x()) - heading_rad;
  EXPECT_NEAR(std::remainder(azimuth_rad - placed.azimuth_rad, 2.0 * kPi), 0.0, 1e-9);
}

TEST(SunMotion, KeepsTheStrayLightOfTheScenario) {
  SunModel sun = Placed(true);
  EXPECT_TRUE(LightAt(LightingOf(true), 600.0).stray.none());
  sun.stray = {.veil = 0.03, .core_rad = 0.02, .ghosts = 4e-4};
  const Lighting lighting = MakeLighting(Light::kEven, kX_WD, {0.0, 0.0, 0.5}, 7, sun);
  const StrayLight stray = LightAt(lighting, 600.0).stray;
  EXPECT_EQ(stray.veil, 0.03);
  EXPECT_EQ(stray.core_rad, 0.02);
  EXPECT_EQ(stray.ghosts, 4e-4);
}

}  // namespace
}  // namespace dockyard
