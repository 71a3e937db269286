#include "sim/vehicles/rock_roughness.h"

#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Wavelengths, halved from one octave to the next, and waves of each. Amplitudes go with the
// wavelength, as broken rock's do (self-affine, exponent near 1; assumed 0.7-1).
constexpr double kLongest_m = 0.1;
constexpr int kOctaves = 4, kWaves = 24;

}  // namespace

RockRoughness::RockRoughness(double rms_m, RandomStream& random) {
  double sum = 0.0;
  for (int o = 0; o < kOctaves; ++o) sum += std::pow(0.25, o);
  for (int o = 0; o < kOctaves; ++o) {
    const double octave_m = rms_m * std::pow(0.5, o) / std::sqrt(sum);
    for (int i = 0; i < kWaves; ++i) {
      const double z = random.Uniform(-1.0, 1.0), angle = random.Uniform(-kPi, kPi);
      const double r = std::sqrt(1.0 - z * z);
      const double length_m = kLongest_m * std::pow(0.5, o + random.Uniform());
      waves_.push_back(
          {2.0 * kPi / length_m * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z),
           random.Uniform(-kPi, kPi), octave_m * std::sqrt(2.0 / kWaves)});
    }
  }
}

double RockRoughness::At(const Eigen::Vector3d& p) const {
  double height_m = 0.0;
  for (const Wave& wave : waves_)
    height_m += wave.height_m * std::cos(wave.k_per_m.dot(p) + wave.phase);
  return height_m;
}

}  // namespace dockyard
