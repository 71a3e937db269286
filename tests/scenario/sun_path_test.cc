// The sun's path against spherical astronomy.
#include "sim/scenario/sun_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

constexpr double kHour_s = 3600.0;

SunModel Moving(double latitude_deg, double north_deg) {
  SunModel sun;
  sun.moving = true;
  sun.latitude_rad = Radians(latitude_deg);
  sun.north_rad = Radians(north_deg);
  return sun;
}

double Elevation(const Eigen::Vector3d& to_sun) { return std::asin(to_sun.z()); }
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Where the sun is by the formulas of the sky's triangle. hour_rad: since noon. The azimuth is
/// from the north, counter-clockwise.
struct InSky {
  double azimuth_rad = 0.0, elevation_rad = 0.0;
};
InSky ByFormulas(double latitude_rad, double declination_rad, double hour_rad) {
  const double sine = std::sin(latitude_rad) * std::sin(declination_rad) +
                      std::cos(latitude_rad) * std::cos(declination_rad) * std::cos(hour_rad);
  // From the south towards the west.
  const double west = std::cos(declination_rad) * std::sin(hour_rad);
  const double south = std::sin(latitude_rad) * std::cos(declination_rad) * std::cos(hour_rad) -
                       std::cos(latitude_rad) * std::sin(declination_rad);
  return {std::atan2(west, -south), std::asin(sine)};
}

TEST(SunPath, IsThatOfTheSkysTriangleAtEveryLatitudeSeasonAndHour) {
  for (const double latitude_deg : {-50.0, 0.0, 34.2, 60.0}) {
    for (const double declination_deg : {-23.0, 0.0, 12.0}) {
      for (const double start_h : {-3.0, -0.5, 2.0}) {
        const double latitude = Radians(latitude_deg), declination = Radians(declination_deg);
        const double north_deg = 25.0;
        const auto at = [&](double hours) {
          const InSky sky = ByFormulas(latitude, declination, Radians(15.0 * hours));
          return DirectionOf(sky.azimuth_rad + Radians(north_deg), sky.elevation_rad);
        };
        const Eigen::Vector3d start = at(start_h);
        const Eigen::Vector3d pole = NorthPole(Moving(latitude_deg, north_deg), start);
        for (const double after_h : {0.01, 1.0, 5.0}) {
          const Eigen::Vector3d later = SunAfter(start, pole, after_h * kHour_s);
          EXPECT_LT(AngleBetween(later, at(start_h + after_h)), 1e-7)
              << latitude_deg << " " << declination_deg << " " << start_h << " " << after_h;
        }
      }
    }
  }
}

TEST(SunPath, TurnsByFifteenDegreesAnHourOnACircleThatTheDeclinationNarrows) {
  const SunModel sun = Moving(34.2, 0.0);
  for (const double declination_deg : {-23.0, 0.0, 15.0}) {
    const InSky sky = ByFormulas(sun.latitude_rad, Radians(declination_deg), Radians(-20.0));
    const Eigen::Vector3d start = DirectionOf(sky.azimuth_rad, sky.elevation_rad);
    const Eigen::Vector3d later = SunAfter(start, NorthPole(sun, start), 2.0 * kHour_s);
    const double chord = 2.0 * std::cos(Radians(declination_deg)) * std::sin(Radians(15.0));
    EXPECT_NEAR((later - start).norm(), chord, 1e-12);
  }
}

TEST(SunPath, AtAnEquinoxNoonIsAsFarBelowTheZenithAsTheLatitudeAndSixHoursLaterItSetsInTheWest) {
  const SunModel sun = Moving(34.2, 90.0);  // the north to the left
  const Eigen::Vector3d noon = DirectionOf(Radians(-90.0), Radians(90.0 - 34.2));
  const Eigen::Vector3d pole = NorthPole(sun, noon);
  EXPECT_NEAR(noon.dot(pole), 0.0, 1e-12);
  const Eigen::Vector3d west = SunAfter(noon, pole, 6.0 * kHour_s);
  EXPECT_LT(AngleBetween(west, DirectionOf(Radians(180.0), 0.0)), 1e-9);
}

TEST(SunPath, WithoutANorthItIsNoonAtTheStartOnBothHalvesOfTheEarth) {
  for (const double latitude_deg : {34.2, -34.2}) {
    SunModel sun = Moving(latitude_deg, 0.0);
    sun.north_rad = std::nan("");
    const Eigen::Vector3d start = DirectionOf(Radians(40.0), Radians(50.0));
    const Eigen::Vector3d pole = NorthPole(sun, start);
    const Eigen::Vector3d before = SunAfter(start, pole, -kHour_s);
    const Eigen::Vector3d after = SunAfter(start, pole, kHour_s);
    EXPECT_NEAR(Elevation(before), Elevation(after), 1e-12);
    EXPECT_GT(Elevation(start), Elevation(after) + Radians(0.5));
    // It goes west: with the sun before one to the right in the north, to the left in the south.
    const double left = std::atan2(after.y(), after.x()) - Radians(40.0);
    EXPECT_EQ(left<0.0, latitude_deg> 0.0);
  }
}

TEST(SunPath, HasASeasonWithinTheObliquity) {
  SunModel sun = Moving(34.2, 0.0);
  EXPECT_TRUE(HasASeason(sun)) << "its place is drawn";
  sun.azimuth_rad = Radians(180.0);  // noon
  sun.elevation_rad = Radians(90.0 - 34.2 + 23.0);
  EXPECT_TRUE(HasASeason(sun));
  sun.elevation_rad = Radians(90.0 - 34.2 + 24.0);
  EXPECT_FALSE(HasASeason(sun));
  sun.moving = false;
  EXPECT_TRUE(HasASeason(sun));
  sun.moving = true;
  sun.north_rad = std::nan("");
  sun.elevation_rad = Radians(90.0 - 34.2 - 24.0);
  EXPECT_FALSE(HasASeason(sun));
}

}  // namespace
}  // namespace dockyard
