// Axel's attitude over a docking, by an inertial unit with a filter of its own and without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "axel/sim/scenarios.h"
#include "controller/geometry/axle_attitude.h"
#include "sim/log/run_log.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

/// Root mean square and largest value of a pitch's errors.
struct Spread {
  double square = 0.0, count = 0.0, worst = 0.0;
  void Add(double error) {
    square += error * error;
    count += 1.0;
    worst = std::max(worst, std::abs(error));
  }
  double rms() const { return std::sqrt(square / count); }
};

struct Errors {
  Spread swinging, calm;   // while the body pitches by more than 5 deg/s, and else [deg]
  double swing_deg = 0.0;  // from the least true pitch to the largest
};

/// The attitudes that the controller got, by tick.
std::map<Tick, ImuSample> Read(const std::filesystem::path& dir) {
  std::map<Tick, ImuSample> read;
  RunLogReader log{Folder(dir)};
  while (const auto entry = log.Next()) read[entry->sensed.tick] = entry->sensed.imu;
  return read;
}

/// Pitch that the controller got against the true one, at the history's 10 Hz.
Errors PitchErrors(const std::vector<std::string>& keys) {
  const ScratchFolder folder;
  RunOptions options;
  options.log_dir = folder.path() / "run";
  options.log_images = false;
  const RunRecord record = SimulateTypical(keys, options);
  const std::map<Tick, ImuSample> read = Read(options.log_dir);
  std::size_t pitch = 0;
  while (record.channels[pitch].name != "pitch_deg") ++pitch;
  Errors errors;
  double least = 1e9, most = -1e9, last = record.history.front().channels[pitch];
  for (const HistorySample& sample : record.history) {
    const double now = sample.channels[pitch], turned = std::abs(now - std::exchange(last, now));
    least = std::min(least, now);
    most = std::max(most, now);
    const auto at = read.find(std::llround(sample.time_s / kTickSeconds));
    if (at == read.end()) continue;  // of the judge's trial
    const ImuSample& imu = at->second;
    const double read_rad =
        ToAxleAttitude(ToRotation(RollPitchYaw{imu.roll_rad, imu.pitch_rad, imu.yaw_rad})).pitch;
    (turned > 0.5 ? errors.swinging : errors.calm).Add(Degrees(WrapPi(read_rad - Radians(now))));
  }
  errors.swing_deg = most - least;
  return errors;
}

// A bias of 0.2 deg and a noise of 0.05 deg, 1 sigma, whatever the body does.
TEST(AttitudeOverADocking, WithoutAFilterErrsAlikeWhetherTheBodySwingsOrNot) {
  const Errors errors = PitchErrors({});
  EXPECT_GT(errors.swing_deg, 15.0);
  EXPECT_LT(errors.swinging.worst, 4.0 * 0.2 + 5.0 * 0.05);
  EXPECT_NEAR(errors.swinging.rms(), errors.calm.rms(), 0.3 * errors.calm.rms());
}

// The body's swings push the accelerometers, which the filter takes for gravity: at this seed its
// pitch errs by 0.57 deg rms while the body swings, by 2.0 deg at worst, and by 0.17 deg else.
TEST(AttitudeOverADocking, WithAFilterErrsByDegreesAsTheBodySwings) {
  const Errors errors = PitchErrors(
      {"changes.robot.imu={attitude_noise_deg: 0, attitude_bias_deg: 0, filter: {kind: mahony, "
       "rate_hz: 100}}"});
  EXPECT_GT(errors.swing_deg, 15.0);
  EXPECT_GT(errors.swinging.rms(), 2.0 * errors.calm.rms());
  EXPECT_GT(errors.swinging.worst, 1.0);
  EXPECT_LT(errors.swinging.worst, 6.0);
}

}  // namespace
}  // namespace dockyard::axel
