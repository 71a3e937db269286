#include "sim/plant/opacity.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Of suspended dust over the sun's spectrum. Fitted to Pollack's fluxes at Mars' surface
// (Appelbaum and Flood, Solar Energy 45, 353 (1990), table III), of which they are within 0.05 up
// to 80 deg from the zenith. Range: 0.85-0.97 and 0.6-0.8.
constexpr double kScatterAlbedo = 0.89, kAsymmetry = 0.75;

}  // namespace

double AirMass(double elevation_rad) {
  return 1.0 /
         (std::sin(elevation_rad) + 0.50572 * std::pow(Degrees(elevation_rad) + 6.07995, -1.6364));
}

double TotalTransmission(double depth, double cosine, double albedo, double asymmetry) {
  // The forward peak counts as unscattered.
  const double peak = asymmetry * asymmetry;
  const double t = (1.0 - albedo * peak) * depth;
  const double w = (1.0 - peak) * albedo / (1.0 - albedo * peak);
  const double g = asymmetry / (1.0 + asymmetry);
  const double g1 = 0.25 * (7.0 - w * (4.0 + 3.0 * g)), g2 = -0.25 * (1.0 - w * (4.0 - 3.0 * g));
  const double k = std::sqrt(g1 * g1 - g2 * g2);
  // At k cosine = 1 the form is 0 / 0.
  const double off = 1.0 - k * cosine;
  const double mu = std::abs(off) < 1e-5 ? (1.0 + 1e-5) / k : cosine;
  const double g3 = 0.25 * (2.0 - 3.0 * g * mu), g4 = 1.0 - g3;
  const double a1 = g1 * g4 + g2 * g3;
  const double up = std::exp(k * t), down = std::exp(-k * t);
  const double below = (1.0 - k * k * mu * mu) * ((k + g1) * up + (k - g1) * down);
  const double scattered =
      (1.0 + k * mu) * (a1 + k * g4) * up - (1.0 - k * mu) * (a1 - k * g4) * down;
  const double direct = std::exp(-t / mu);
  return direct * (1.0 - w * scattered / below) + 2.0 * w * k * (g4 + a1 * mu) / below;
}

AirLight LightThroughAir(double depth, double elevation_rad) {
  const double mass = AirMass(elevation_rad), sun = std::exp(-depth * mass);
  const double total = TotalTransmission(depth, 1.0 / mass, kScatterAlbedo, kAsymmetry);
  return {.sun = sun, .sky = std::sin(elevation_rad) * std::max(total - sun, 0.0)};
}

}  // namespace dockyard
