// Rocky 7's images as analogue video.
#include <gtest/gtest.h>

#include "models/read/yaml_tree.h"
#include "rocky7/sim/test_scenario.h"
#include "sim/rocky7/rocky7_plant.h"
#include "support/line_shift.h"

namespace dockyard::rocky7 {
namespace {

std::unique_ptr<Rocky7Plant> Plant(const std::string& fields, const std::string& noise_share) {
  Scenario scenario = OnGravel("{task: place}", 2.0, 5.0);  // the mast watches ahead
  // Hardly any noise: the images differ by their fields alone.
  scenario.changes = ParseYaml(
      "{robot: {cameras: {sensor: {full_well_e: 1e6, read_noise_e: 0, shutter_s: 0, exposure: "
      "{rule: fixed, fixed_e: 9e5}, video: {line_jitter_px: 0, fields: " +
          fields + ", noise_share: " + noise_share + "}}}}}",
      "test");
  return std::make_unique<Rocky7Plant>(scenario, BuildRun(scenario, LoadModels(scenario)),
                                       std::make_shared<KeptRenderer>());
}

/// The wheels of one side turn against those of the other.
void Turn(Rocky7Plant& plant, double wheels_rad_s, double seconds) {
  const Nominal& nominal = plant.built().nominal;
  Commands commands;
  commands.motors.resize(nominal.motors.size());  // the others are braked
  for (std::size_t i = 0; wheels_rad_s != 0.0 && i < nominal.plan.wheels.size(); ++i) {
    const double rad_s = nominal.plan.wheels[i].p_RW.y() > 0.0 ? -wheels_rad_s : wheels_rad_s;
    commands.motors[i] = {MotorMode::kVelocity, rad_s, 0.0, 3.0, 3.0};
  }
  for (int i = 0; i < seconds / (kControlPeriod * kTickSeconds); ++i) plant.Advance(commands);
  plant.RefreshTruth();
}

GrayImage LeftOf(Rocky7Plant& plant, int camera) {
  return std::get<GrayImage>(plant.TakeImages({camera}, 0.0).at(0).pixels);
}

TEST(Rocky7Video, OddLinesOfATurningRoverAreAFieldLaterAndOfAStandingOneOfNow) {
  const auto whole = Plant("progressive", "0"), video = Plant("interlaced", "0");
  for (Rocky7Plant* plant : {whole.get(), video.get()}) Turn(*plant, 0.0, 2.0);
  for (const int camera : {kFrontLeft, kMastLeft}) {
    EXPECT_EQ(LeftOf(*video, camera), LeftOf(*whole, camera));
  }
  for (Rocky7Plant* plant : {whole.get(), video.get()}) Turn(*plant, 0.25, 1.0);
  const BuiltRun& built = video->built();
  const double turning_rad_s = video->truth().w_WR_W.z();
  const double field_px = built.mast_pair.left.focal_px().x() * turning_rad_s / 60.0;
  ASSERT_GT(field_px, 0.2);
  const GrayImage now = LeftOf(*whole, kMastLeft), lines = LeftOf(*video, kMastLeft);
  const double even = ShiftOfLines_px(lines, now, 0), odd = ShiftOfLines_px(lines, now, 1);
  EXPECT_NEAR(odd - even, field_px, 0.15 * field_px);
  EXPECT_NEAR(odd + even, 0.0, 0.1 * field_px);
}

TEST(Rocky7Video, TheFrameGrabbersNoiseIsThatOfTheFrontPairsFileInEveryPair) {
  const auto clean = Plant("progressive", "0"), noisy = Plant("progressive", "0.008");
  for (const int camera : {kFrontLeft, kMastLeft, kBackLeft}) {
    const GrayImage a = LeftOf(*clean, camera), b = LeftOf(*noisy, camera);
    double square = 0.0, count = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      if (a.pixels[i] < 16 || a.pixels[i] > 239) continue;
      square += std::pow(b.pixels[i] - a.pixels[i], 2);
      ++count;
    }
    // Two roundings add 1/12 each, in the mean.
    EXPECT_NEAR(std::sqrt(square / count - 2.0 / 12.0), 0.008 * 255.0, 0.03 * 0.008 * 255.0)
        << camera;
  }
}

}  // namespace
}  // namespace dockyard::rocky7
