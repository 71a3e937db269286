// The sun by date and hour against published places and closed forms.
#include "sim/scenario/sun_date.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

SunModel Dated(const std::string& date, double hour, double latitude_deg, double north_deg) {
  SunModel sun;
  sun.date = date;
  sun.hour = hour;
  sun.latitude_rad = Radians(latitude_deg);
  sun.north_rad = Radians(north_deg);
  return sun;
}

double DeclinationAt(int month, int day, double hour) {
  return Degrees(SunDeclination_rad(DaysFrom2000({month, day}, hour)));
}

// Meeus, Astronomical Algorithms, example 25.a: 1992 October 13.0, JDE 2448908.5, apparent
// declination -7 deg 47' 06".
TEST(SunDate, HasTheDeclinationOfMeeusExample) {
  EXPECT_NEAR(Degrees(SunDeclination_rad(2448908.5 - 2451545.0)), -7.78507, 1e-4);
}

// Equinoxes and solstices of 2013 (Earth's seasons, US Naval Observatory): March 20, 11:02; June
// 21, 05:04; September 22, 20:44; December 21, 17:11, Universal Time.
TEST(SunDate, HasTheSeasonsOf2013) {
  EXPECT_NEAR(DeclinationAt(3, 20, 11.03), 0.0, 0.01);
  EXPECT_NEAR(DeclinationAt(6, 21, 5.07), 23.436, 0.01);
  EXPECT_NEAR(DeclinationAt(9, 22, 20.73), 0.0, 0.01);
  EXPECT_NEAR(DeclinationAt(12, 21, 17.18), -23.436, 0.01);
}

TEST(SunDate, IsInTheMeridianAtNoonAsHighAsItsDeclinationSays) {
  for (const double north_deg : {0.0, 70.0, -120.0}) {
    const SunModel sun = PlacedByDate(Dated("06-21", 12.0, 34.2, north_deg));
    EXPECT_NEAR(Degrees(sun.elevation_rad), 90.0 - 34.2 + DeclinationAt(6, 21, 12.0), 1e-6);
    EXPECT_NEAR(std::remainder(sun.azimuth_rad - Radians(north_deg + 180.0), 2.0 * kPi), 0.0, 1e-9);
  }
  const SunModel south = PlacedByDate(Dated("06-21", 12.0, -34.2, 0.0));
  EXPECT_NEAR(south.azimuth_rad, 0.0, 1e-9) << "due north";
}

// Before noon in the east, which is to the right of the north: below it, counter-clockwise.
TEST(SunDate, AnEquinoxSunRisesInTheEastAndSetsInTheWest) {
  const SunModel morning = PlacedByDate(Dated("03-20", 6.0, 34.2, 30.0));
  const SunModel evening = PlacedByDate(Dated("03-20", 18.0, 34.2, 30.0));
  EXPECT_NEAR(Degrees(morning.elevation_rad), 0.0, 0.2);
  EXPECT_NEAR(Degrees(morning.azimuth_rad), 30.0 - 90.0, 0.2);
  EXPECT_NEAR(Degrees(evening.azimuth_rad), 30.0 + 90.0, 0.2);
}

// Sunrise on the longest day: cos(azimuth from the north) = sin(declination) / cos(latitude).
TEST(SunDate, RisesWhereTheAmplitudeSays) {
  const double latitude = Radians(34.2), declination = Radians(DeclinationAt(6, 21, 5.0));
  const double hour = 12.0 - Degrees(std::acos(-std::tan(latitude) * std::tan(declination))) / 15.0;
  const SunModel sun = PlacedByDate(Dated("06-21", hour, 34.2, 0.0));
  EXPECT_NEAR(Degrees(sun.elevation_rad), 0.0, 0.01);
  EXPECT_NEAR(Degrees(-sun.azimuth_rad),
              Degrees(std::acos(std::sin(declination) / std::cos(latitude))), 0.01);
}

TEST(SunDate, MovesAsTheSunsPathSays) {
  for (const double latitude_deg : {34.2, -20.0}) {
    const SunModel at_ten = PlacedByDate(Dated("10-15", 10.0, latitude_deg, 25.0));
    const SunModel at_two = PlacedByDate(Dated("10-15", 14.0, latitude_deg, 25.0));
    const Eigen::Vector3d start = DirectionOf(at_ten.azimuth_rad, at_ten.elevation_rad);
    const Eigen::Vector3d moved = SunAfter(start, NorthPole(at_ten, start), 4.0 * 3600.0);
    const Eigen::Vector3d later = DirectionOf(at_two.azimuth_rad, at_two.elevation_rad);
    // In four hours the declination changes by 0.06 deg.
    EXPECT_LT(Degrees(std::acos(std::min(moved.dot(later), 1.0))), 0.07);
  }
}

TEST(SunDate, WithoutADateTheModelIsAsItIs) {
  SunModel sun;
  sun.azimuth_rad = 0.3;
  EXPECT_EQ(PlacedByDate(sun).azimuth_rad, 0.3);
  EXPECT_TRUE(std::isnan(PlacedByDate(sun).elevation_rad));
}

TEST(SunDate, ReadsMonthAndDay) {
  EXPECT_EQ(ParseSunDate("02-28")->month, 2);
  EXPECT_EQ(ParseSunDate("12-31")->day, 31);
  for (const char* text :
       {"", "6-21", "06/21", "13-01", "00-10", "02-29", "04-31", "0a-01", "06-210"}) {
    EXPECT_FALSE(ParseSunDate(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace dockyard
