// Keys of the sun: what good values become and how bad ones are reported.
#include <gmock/gmock.h>

#include <cmath>

#include "scenario/toy_system.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

class SunKeys : public testing::Test {
 protected:
  Scenario Loaded(const std::string& lines) const {
    return LoadScenario(folder_.And(lines), {}, ToySystems());
  }
  std::string Refused(const std::string& lines) const {
    return folder_.ScenarioMessage(folder_.And(lines));
  }

  ToyFolder folder_;
};

TEST_F(SunKeys, WhatIsLeftOutIsDrawnByTheKindOfLight) {
  const Scenario s = Loaded("");
  EXPECT_TRUE(std::isnan(s.sun.azimuth_rad));
  EXPECT_TRUE(std::isnan(s.sun.elevation_rad));
  EXPECT_EQ(s.sun.temperature_k, 0.0);
  EXPECT_EQ(s.sun.sky_temperature_k, 0.0);
}

TEST_F(SunKeys, AnglesArriveInRadians) {
  const Scenario s = Loaded(
      "sun: {azimuth_deg: -30, elevation_deg: 12.5, temperature_k: 4500, sky_temperature_k: "
      "12000}");
  EXPECT_EQ(s.sun.azimuth_rad, Radians(-30.0));
  EXPECT_EQ(s.sun.elevation_rad, Radians(12.5));
  EXPECT_EQ(s.sun.temperature_k, 4500.0);
  EXPECT_EQ(s.sun.sky_temperature_k, 12000.0);
}

TEST_F(SunKeys, BadSunIsReportedByPlace) {
  EXPECT_EQ(Refused("sun: {azimuth_deg: 181}"),
            "scenarios/s.yaml:10:20: sun.azimuth_deg: expected a number from -180 to 180, found "
            "'181'");
  EXPECT_EQ(Refused("sun: {elevation_deg: 1}"),
            "scenarios/s.yaml:10:22: sun.elevation_deg: expected a number from 2 to 90, found '1'");
  EXPECT_EQ(Refused("sun: {temperature_k: 1000}"),
            "scenarios/s.yaml:10:22: sun.temperature_k: expected a number from 1667 to 25000, "
            "found '1000'");
  EXPECT_EQ(Refused("sun: {elevation: 30}"),
            "scenarios/s.yaml:10:7: sun.elevation: unknown key, did you mean 'elevation_deg'?");
  EXPECT_EQ(Refused("sun: noon"),
            "scenarios/s.yaml:10:6: sun: expected a mapping (key: value), found 'noon'");
}

TEST_F(SunKeys, ASunStaysUnlessItIsToMove) {
  EXPECT_FALSE(Loaded("").sun.moving);
  const Scenario noon = Loaded("sun: {moving: true}");
  EXPECT_TRUE(noon.sun.moving);
  EXPECT_EQ(noon.sun.latitude_rad, Radians(34.2));
  EXPECT_TRUE(std::isnan(noon.sun.north_rad));
  const Scenario placed = Loaded(
      "sun: {moving: true, latitude_deg: -20, azimuth_deg: 30, elevation_deg: 60, north_deg: 45}");
  EXPECT_EQ(placed.sun.latitude_rad, Radians(-20.0));
  EXPECT_EQ(placed.sun.north_rad, Radians(45.0));
  EXPECT_TRUE(DifferingKeys(placed, ReadScenario(WriteScenario(placed), ToySystems())).empty());
}

TEST_F(SunKeys, OpacityAndStrayLightAreOffUnlessGiven) {
  const Scenario plain = Loaded("");
  EXPECT_TRUE(std::isnan(plain.sun.opacity));
  EXPECT_EQ(plain.sun.stray.veil, 0.0);
  EXPECT_EQ(plain.sun.stray.ghosts, 0.0);
  const Scenario given =
      Loaded("sun: {opacity: 0}\ncamera: {stray: {veil: 0.02, core_deg: 1, ghosts: 0.0003}}");
  EXPECT_EQ(given.sun.opacity, 0.0);
  EXPECT_EQ(given.sun.stray.veil, 0.02);
  EXPECT_EQ(given.sun.stray.core_rad, Radians(1.0));
  EXPECT_EQ(given.sun.stray.ghosts, 0.0003);
  EXPECT_TRUE(DifferingKeys(given, ReadScenario(WriteScenario(given), ToySystems())).empty());
  EXPECT_EQ(Refused("sun: {opacity: -1}"),
            "scenarios/s.yaml:10:16: sun.opacity: expected a number >= 0, found '-1'");
  EXPECT_EQ(Refused("camera: {stray: {veil: 0.5}}"),
            "scenarios/s.yaml:10:24: camera.stray.veil: expected a number >= 0 and <= 0.2, found "
            "'0.5'");
}

TEST_F(SunKeys, ADateAndAnHourReplaceTheAngles) {
  const Scenario s = Loaded("sun: {date: 06-21, hour: 9.5, latitude_deg: 34.2, north_deg: 45}");
  EXPECT_EQ(s.sun.date, "06-21");
  EXPECT_EQ(s.sun.hour, 9.5);
  EXPECT_TRUE(DifferingKeys(s, ReadScenario(WriteScenario(s), ToySystems())).empty());
}

TEST_F(SunKeys, BadDateIsRefused) {
  using ::testing::HasSubstr;
  EXPECT_EQ(Refused("sun: {date: 06-31, hour: 9, north_deg: 0}"),
            "scenarios/s.yaml:10:13: sun.date: expected a month and a day, as '06-21', found "
            "'06-31'");
  EXPECT_THAT(Refused("sun: {date: 06-21, north_deg: 0}"), HasSubstr("expected hour next to it"));
  EXPECT_THAT(Refused("sun: {hour: 9, north_deg: 0}"), HasSubstr("expected date next to it"));
  EXPECT_THAT(Refused("sun: {date: 06-21, hour: 9}"), HasSubstr("expected north_deg next to it"));
  EXPECT_THAT(Refused("sun: {date: 06-21, hour: 9, north_deg: 0, azimuth_deg: 10}"),
              HasSubstr("sun.azimuth_deg: expected either azimuth_deg and elevation_deg or date"));
  EXPECT_THAT(Refused("sun: {date: 06-21, hour: 9, north_deg: 0, elevation_deg: 10}"),
              HasSubstr("sun.elevation_deg: expected either"));
  EXPECT_THAT(Refused("sun: {date: 12-21, hour: 6, north_deg: 0}"),
              HasSubstr("an hour at which the sun is at least 2 deg high, found a sun -12.9 deg"));
}

TEST_F(SunKeys, BadPathOfTheSunIsRefused) {
  using ::testing::HasSubstr;
  EXPECT_THAT(Refused("sun: {moving: true, north_deg: 10, azimuth_deg: 5}"),
              HasSubstr("sun.north_deg: expected azimuth_deg and elevation_deg next to it"));
  EXPECT_THAT(Refused("sun: {moving: true, latitude_deg: 70}"), HasSubstr("from -66 to 66"));
  EXPECT_THAT(
      MessageOf(
          [&] { LoadScenario(folder_.And("sun: {moving: true}"), {"light=room"}, ToySystems()); },
          folder_),
      HasSubstr("sun.moving: expected false"));
  EXPECT_THAT(Refused("sun: {moving: true, elevation_deg: 20}"),
              HasSubstr("within 23.45 deg of the celestial equator"));
  EXPECT_THAT(Refused("sun: {moving: true, azimuth_deg: 0, elevation_deg: 50, north_deg: 0}"),
              HasSubstr("within 23.45 deg of the celestial equator"));
}

}  // namespace
}  // namespace dockyard
