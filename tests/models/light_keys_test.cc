// Keys of the light, the dust and the exposure: what good values become and how bad ones are told.
#include <gmock/gmock.h>

#include <cmath>

#include "bad_files.h"
#include "models/load_scenario.h"

namespace dockyard {
namespace {

const char kTypical[] = "scenarios/axel_typical.yaml";
const char kRover[] = "models/axel/axel.yaml";

class LightKeys : public testing::Test {
 protected:
  LightKeys() {
    for (const char* model : {"axel", "station", "soils"}) folder_.CopyModel(model);
  }
  /// The typical scenario with lines after "light: even" (its line 9).
  std::string File(const std::string& lines) const {
    return folder_.Write("scenarios/s.yaml", Replaced(Slurp(SourceFile(kTypical)), "light: even\n",
                                                      "light: even\n" + lines + "\n"));
  }
  Scenario Loaded(const std::string& lines) const { return LoadScenario(File(lines)); }
  std::string Refused(const std::string& lines) const {
    const std::string file = File(lines);
    return MessageOf([&] { LoadScenario(file); }, folder_);
  }
  /// The rover's file with lines in cameras.sensor.
  std::string WithSensor(const std::string& lines) const {
    const std::string text =
        Replaced(Slurp(SourceFile(kRover)), "\n  sensor:\n", "\n  sensor:\n" + lines + "\n");
    folder_.Write(kRover, text);
    return File("");
  }
  ExposureModel Exposure(const std::string& lines) const {
    return LoadModels(LoadScenario(WithSensor(lines))).rover.stereo.exposure;
  }
  std::string ExposureRefused(const std::string& lines) const {
    const std::string file = WithSensor(lines);
    const std::string text = Slurp(folder_.path() / kRover);
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(lines)),
                       '\n');
    const std::string message = MessageOf([&] { LoadModels(LoadScenario(file)); }, folder_);
    const std::string place = std::string(kRover) + ":" + std::to_string(line) + ":";
    EXPECT_THAT(message, testing::StartsWith(place));
    return message.substr(std::min(message.size(), place.size()));
  }

  ScratchFolder folder_;
};

TEST_F(LightKeys, WhatIsLeftOutIsDrawnByTheKindOfLight) {
  const Scenario s = Loaded("");
  EXPECT_TRUE(std::isnan(s.sun.azimuth_rad));
  EXPECT_TRUE(std::isnan(s.sun.elevation_rad));
  EXPECT_EQ(s.sun.temperature_k, 0.0);
  EXPECT_EQ(s.board_dust, 0.0);
}

TEST_F(LightKeys, SunAndDustArriveInRadiansAndShares) {
  const Scenario s = Loaded(
      "sun: {azimuth_deg: -30, elevation_deg: 12.5, temperature_k: 4500, sky_temperature_k: "
      "12000}\nboard_dust: 0.25");
  EXPECT_DOUBLE_EQ(s.sun.azimuth_rad, Radians(-30.0));
  EXPECT_DOUBLE_EQ(s.sun.elevation_rad, Radians(12.5));
  EXPECT_EQ(s.sun.temperature_k, 4500.0);
  EXPECT_EQ(s.sun.sky_temperature_k, 12000.0);
  EXPECT_EQ(s.board_dust, 0.25);
}

TEST_F(LightKeys, BadSunIsToldByPlace) {
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

TEST_F(LightKeys, BadDustIsToldByPlace) {
  EXPECT_EQ(Refused("board_dust: 0.7"),
            "scenarios/s.yaml:10:13: board_dust: expected a number >= 0 and <= 0.6, found '0.7'");
  EXPECT_EQ(Refused("board_dust: -0.1"),
            "scenarios/s.yaml:10:13: board_dust: expected a number >= 0, found '-0.1'");
  EXPECT_EQ(Refused("board_dust: much"),
            "scenarios/s.yaml:10:13: board_dust: expected a number >= 0, found 'much'");
}

TEST_F(LightKeys, ExposureIsAutomaticUnlessTheFileSays) {
  const ExposureModel given = Exposure("    exposure: {rule: automatic, percent: 2, level: 0.6}");
  EXPECT_EQ(given.rule, ExposureRule::kAutomatic);
  EXPECT_EQ(given.percent, 2.0);
  EXPECT_EQ(given.level, 0.6);
}

TEST_F(LightKeys, FixedExposureHoldsItsElectrons) {
  const ExposureModel given = Exposure("    exposure: {rule: fixed, fixed_e: 30000}");
  EXPECT_EQ(given.rule, ExposureRule::kFixed);
  EXPECT_EQ(given.fixed_e, 30000.0);
}

TEST_F(LightKeys, BracketHoldsItsStops) {
  const ExposureModel given = Exposure("    exposure: {rule: bracketed, bracket_stops: 1.5}");
  EXPECT_EQ(given.rule, ExposureRule::kBracketed);
  EXPECT_EQ(given.bracket_stops, 1.5);
}

TEST_F(LightKeys, BadRuleIsToldByPlace) {
  EXPECT_EQ(ExposureRefused("    exposure: {rule: manual}"),
            "22: cameras.sensor.exposure.rule: expected one of automatic, fixed, bracketed, found "
            "'manual'");
}

TEST_F(LightKeys, BadPercentIsToldByPlace) {
  EXPECT_EQ(ExposureRefused("    exposure: {percent: 100}"),
            "25: cameras.sensor.exposure.percent: expected a number from 0.01 to 99, found '100'");
}

TEST_F(LightKeys, FixedExposureWithoutElectronsIsRefused) {
  EXPECT_EQ(ExposureRefused("    exposure: {rule: fixed}"),
            "15: cameras.sensor.exposure: missing key 'fixed_e'");
}

TEST_F(LightKeys, UnknownExposureKeyIsRefused) {
  EXPECT_EQ(ExposureRefused("    exposure: {stops: 1}"),
            "16: cameras.sensor.exposure.stops: unknown key, known are: rule, percent, level, "
            "fixed_e, bracket_stops");
}

}  // namespace
}  // namespace dockyard
