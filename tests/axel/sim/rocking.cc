#include "axel/sim/rocking.h"

#include <algorithm>
#include <cmath>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

constexpr double kSeconds = 40.0, kBefore_s = 5.0;  // until wheels and tether are under way
constexpr double kHighest_hz = 2.5;

std::vector<double> Straightened(const std::vector<double>& signal) {
  const double n = static_cast<double>(signal.size()), middle = 0.5 * (n - 1.0);
  double mean = 0.0, moment = 0.0, square = 0.0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double from_middle = static_cast<double>(i) - middle;
    mean += signal[i] / n;
    moment += from_middle * signal[i];
    square += from_middle * from_middle;
  }
  std::vector<double> out(signal.size());
  for (std::size_t i = 0; i < signal.size(); ++i) {
    out[i] = signal[i] - mean - (static_cast<double>(i) - middle) * moment / square;
  }
  return out;
}

double Most(const std::vector<double>& signal) {
  double most = 0.0;
  for (double value : Straightened(signal)) most = std::max(most, std::abs(value));
  return most;
}

void AddTo(Spectrum& sum, const Spectrum& one, double share) {
  sum.hertz = one.hertz;
  sum.power.resize(one.power.size());
  for (std::size_t i = 0; i < one.power.size(); ++i) sum.power[i] += share * one.power[i];
}

}  // namespace

Rocking ReelOver(const SoilModel& soil, double right_phase_rad) {
  WorldSetup setup = TestSetup(soil, {4.5, 0.0, kPi});
  setup.rover.right_wheel_soil.phase_rad = right_phase_rad;
  World world(setup);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  At(commands, Motor::kSpool) = Velocity(1.0, 2.0);  // 0.06 m/s
  Play(world, commands, kBefore_s);
  Rocking rocking;
  for (double t = 0.0; t < kSeconds - 1e-9; t += kRockingSample_s) {
    Play(world, commands, kRockingSample_s);
    const Eigen::Matrix3d& R = world.truth().X_WR.R;
    rocking.roll_deg.push_back(Degrees(std::asin(R(2, 1))));
    rocking.heading_deg.push_back(Degrees(std::asin(R(1, 0))));
  }
  return rocking;
}

double Spectrum::PowerNear(double at_hz) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < hertz.size(); ++i) {
    if (std::abs(hertz[i] - at_hz) <= 0.125 * at_hz) sum += power[i];
  }
  return sum;
}

Spectrum SpectrumOf(const std::vector<double>& signal, double highest_hz) {
  // A discrete Fourier transform: multiples of one over the record's length.
  const std::vector<double> straight = Straightened(signal);
  const double n = static_cast<double>(straight.size());
  Spectrum spectrum;
  for (int k = 1; k / (n * kRockingSample_s) <= highest_hz; ++k) {
    double in = 0.0, quad = 0.0;
    for (std::size_t i = 0; i < straight.size(); ++i) {
      const double angle = 2.0 * kPi * k * static_cast<double>(i) / n;
      in += straight[i] * std::cos(angle);
      quad += straight[i] * std::sin(angle);
    }
    spectrum.hertz.push_back(k / (n * kRockingSample_s));
    spectrum.power.push_back(2.0 * (in * in + quad * quad) / (n * n));
  }
  return spectrum;
}

RockingSpectra MeanSpectra(const SoilModel& soil) {
  RockingSpectra mean;
  constexpr int kRuns = 4;
  for (int run = 0; run < kRuns; ++run) {
    const double pitch = 2.0 * kPi / 12.0;
    const Rocking rocking = ReelOver(soil, (run + 0.5) * pitch / kRuns);
    AddTo(mean.roll, SpectrumOf(rocking.roll_deg, kHighest_hz), 1.0 / kRuns);
    AddTo(mean.heading, SpectrumOf(rocking.heading_deg, kHighest_hz), 1.0 / kRuns);
    mean.most_roll_deg = std::max(mean.most_roll_deg, Most(rocking.roll_deg));
    mean.most_heading_deg = std::max(mean.most_heading_deg, Most(rocking.heading_deg));
  }
  return mean;
}

}  // namespace dockyard::axel
