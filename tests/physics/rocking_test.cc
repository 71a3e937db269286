// Compact soil carries the paddles on their tips, so that the rover rocks from side to side and its
// heading swings; loose sand takes the paddles in (Tsai et al., V-B). Spectra of both, printed.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "physics/product.h"

namespace dockyard {
namespace {

constexpr double kSample_s = 0.02;
constexpr double kWheel_rad_s = 0.2;  // 0.06 m/s on the paddles' tips, 0.30 m from the axle

struct Motion {
  std::vector<double> roll_deg, heading_deg;
};

/// Reels the rover in on free wheels for 25 s and keeps the last 20.
Motion Drive(const SoilModel& soil) {
  WorldSetup setup = TestSetup(soil, {4.5, 0.0, kPi});
  setup.rover.right_wheel_soil.phase_rad = Radians(15.0);  // half a pitch, as axel.yaml has it
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  At(commands, Motor::kSpool) = Velocity(1.0, 2.0);  // 0.06 m/s
  Play(world, commands, 5.0);
  Motion motion;
  for (double t = 0.0; t < 20.0; t += kSample_s) {
    Play(world, commands, kSample_s);
    const Eigen::Matrix3d& R = world.truth().X_WR.R;
    motion.roll_deg.push_back(Degrees(std::asin(R(2, 1))));
    motion.heading_deg.push_back(Degrees(std::asin(R(1, 0))));
  }
  return motion;
}

/// The signal less its mean and trend.
std::vector<double> Straightened(const std::vector<double>& signal) {
  const double n = static_cast<double>(signal.size()), middle = 0.5 * (n - 1.0);
  double mean = 0.0, moment = 0.0, square = 0.0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    mean += signal[i] / n;
    moment += (i - middle) * signal[i];
    square += (i - middle) * (i - middle);
  }
  std::vector<double> out(signal.size());
  for (std::size_t i = 0; i < signal.size(); ++i) {
    out[i] = signal[i] - mean - (i - middle) * moment / square;
  }
  return out;
}

double Rms(const std::vector<double>& signal) {
  double square = 0.0;
  for (double value : signal) square += value * value;
  return std::sqrt(square / static_cast<double>(signal.size()));
}

/// Amplitude of the signal at a frequency.
double Amplitude(const std::vector<double>& signal, double hertz) {
  double in = 0.0, quad = 0.0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    in += signal[i] * std::cos(2.0 * kPi * hertz * kSample_s * i);
    quad += signal[i] * std::sin(2.0 * kPi * hertz * kSample_s * i);
  }
  return 2.0 * std::hypot(in, quad) / static_cast<double>(signal.size());
}

TEST(Rocking, PaddlesRockTheRoverOnCompactSoilAndNotOnLoose) {
  const Motion loose = Drive(LooseSand()), compact = Drive(CompactGravel());
  const double paddles_hz = kWheel_rad_s * 12.0 / (2.0 * kPi);
  const auto report = [&](const char* what, const std::vector<double>& on_loose,
                          const std::vector<double>& on_compact) {
    std::printf("%s, amplitude [deg] at n times the paddles' %.2f Hz\n  n   loose  compact\n", what,
                paddles_hz);
    for (double n : {0.125, 0.25, 0.375, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0, 4.0, 6.0}) {
      std::printf("%5.2f  %.4f  %.4f\n", n, Amplitude(on_loose, n * paddles_hz),
                  Amplitude(on_compact, n * paddles_hz));
    }
    std::printf("  rms  %.4f  %.4f\n", Rms(on_loose), Rms(on_compact));
  };
  const std::vector<double> roll_l = Straightened(loose.roll_deg);
  const std::vector<double> roll_c = Straightened(compact.roll_deg);
  const std::vector<double> heading_l = Straightened(loose.heading_deg);
  const std::vector<double> heading_c = Straightened(compact.heading_deg);
  report("roll", roll_l, roll_c);
  report("heading", heading_l, heading_c);
  EXPECT_GT(Rms(roll_c), 2.0 * Rms(roll_l));
  EXPECT_GT(Rms(heading_c), 2.0 * Rms(heading_l));
  EXPECT_GT(Rms(heading_c), 3.0);  // [deg]: excursions beyond 5 deg
  // Two wheels half a pitch apart, each dropping by R (1 - cos 15 deg) = 10 mm between its tips
  // over a track of 0.85 m: the roll swings at the paddles' frequency, most of the 0.7 deg.
  EXPECT_GT(Amplitude(roll_c, paddles_hz), 0.15);
}

}  // namespace
}  // namespace dockyard
