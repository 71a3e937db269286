// Keys of the cameras' exposure in the rover's file.
#include <gmock/gmock.h>

#include <algorithm>

#include "models/axel/load_axel.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

const char kRover[] = "models/axel/axel.yaml";

class ExposureKeys : public testing::Test {
 protected:
  ExposureKeys() { folder_.CopyModel("axel"); }
  /// The rover's file with lines in cameras.sensor.
  std::string WithSensor(const std::string& lines) const {
    return folder_.Write(kRover, Replaced(Slurp(SourceFile(kRover)), "\n  sensor:\n",
                                          "\n  sensor:\n" + lines + "\n"));
  }
  ExposureModel Exposure(const std::string& lines) const {
    return LoadRover(WithSensor(lines)).stereo.sensor.exposure;
  }
  /// The message after the file and line, which are checked here.
  std::string Refused(const std::string& lines) const {
    const std::string file = WithSensor(lines);
    const std::string text = Slurp(file);
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(lines)),
                       '\n');
    const std::string message = MessageOf([&] { LoadRover(file); }, folder_);
    const std::string place = std::string(kRover) + ":" + std::to_string(line) + ":";
    EXPECT_THAT(message, testing::StartsWith(place));
    return message.substr(std::min(message.size(), place.size()));
  }

  ScratchFolder folder_;
};

TEST_F(ExposureKeys, ExposureIsAutomaticUnlessTheFileSays) {
  const ExposureModel given = Exposure("    exposure: {rule: automatic, percent: 2, level: 0.6}");
  EXPECT_EQ(given.rule, ExposureRule::kAutomatic);
  EXPECT_EQ(given.percent, 2.0);
  EXPECT_EQ(given.level, 0.6);
}

TEST_F(ExposureKeys, TheImageItselfSetsItUnlessTheFileSaysTheOneBefore) {
  EXPECT_EQ(Exposure("    exposure: {rule: automatic}").by, ExposureBy::kSame);
  EXPECT_EQ(Exposure("    exposure: {by: before}").by, ExposureBy::kBefore);
  EXPECT_EQ(Refused("    exposure: {by: after}"),
            "20: cameras.sensor.exposure.by: expected one of same, before, found 'after'");
}

TEST_F(ExposureKeys, DefectsAndReadoutAreThoseOfTheFile) {
  const SensorModel sensor =
      LoadRover(WithSensor("    readout_s: 0.03\n    defects: {hot_share: 0.002, "
                           "hot_rate_e_per_s: 9000, hot_offset_e: 30, dead_share: 0.0005}"))
          .stereo.sensor;
  EXPECT_EQ(sensor.readout_s, 0.03);
  EXPECT_EQ(sensor.defects.hot_share, 0.002);
  EXPECT_EQ(sensor.defects.hot_rate_e_per_s, 9000.0);
  EXPECT_EQ(sensor.defects.hot_offset_e, 30.0);
  EXPECT_EQ(sensor.defects.dead_share, 0.0005);
}

TEST_F(ExposureKeys, InterlacedVideoHasNoRollingShutter) {
  EXPECT_THAT(Refused("    readout_s: 0.01\n    video: {fields: interlaced}"),
              testing::HasSubstr("cameras.sensor.readout_s: expected 0 next to interlaced video"));
}

TEST_F(ExposureKeys, FixedExposureHoldsItsElectrons) {
  const ExposureModel given = Exposure("    exposure: {rule: fixed, fixed_e: 30000}");
  EXPECT_EQ(given.rule, ExposureRule::kFixed);
  EXPECT_EQ(given.fixed_e, 30000.0);
}

TEST_F(ExposureKeys, BracketHoldsItsStops) {
  const ExposureModel given = Exposure("    exposure: {rule: bracketed, bracket_stops: 1.5}");
  EXPECT_EQ(given.rule, ExposureRule::kBracketed);
  EXPECT_EQ(given.bracket_stops, 1.5);
}

TEST_F(ExposureKeys, BadRuleIsReportedByPlace) {
  EXPECT_EQ(Refused("    exposure: {rule: manual}"),
            "22: cameras.sensor.exposure.rule: expected one of automatic, fixed, bracketed, found "
            "'manual'");
}

TEST_F(ExposureKeys, BadPercentIsReportedByPlace) {
  EXPECT_EQ(Refused("    exposure: {percent: 100}"),
            "25: cameras.sensor.exposure.percent: expected a number from 0.01 to 99, found '100'");
}

TEST_F(ExposureKeys, FixedExposureWithoutElectronsIsRefused) {
  EXPECT_EQ(Refused("    exposure: {rule: fixed}"),
            "15: cameras.sensor.exposure: missing key 'fixed_e'");
}

TEST_F(ExposureKeys, UnknownExposureKeyIsRefused) {
  EXPECT_EQ(Refused("    exposure: {stops: 1}"),
            "16: cameras.sensor.exposure.stops: unknown key, known are: rule, by, percent, "
            "level, bracket_stops, fixed_e");
}

}  // namespace
}  // namespace dockyard::axel
