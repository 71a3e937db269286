#include "controller/axel/station_hold.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {

double SureHold(const Nominal& nominal, const HoldOptions& options, double slope_rad) {
  const double weight_n = nominal.station_weight_n * (1.0 - options.weight_share);
  const double friction = nominal.station_friction * (1.0 - options.friction_share);
  return std::max(0.0, weight_n * (friction * std::cos(slope_rad) - std::sin(slope_rad)));
}

double KnownSlope(const Senses& senses) {
  const double lean = std::max(senses.ground().lean_D().norm(), std::abs(senses.side_slope()));
  return std::asin(std::min(1.0, lean));
}

double SeatTension(const AxelOptions& options, const Senses& senses) {
  return options.mate.taut_tension_n +
         options.noise.weight_n * std::max(0.0, -senses.ground().up_D().x());
}

double SurePull(const Nominal& nominal, const HoldOptions& options, const Senses& senses) {
  const double hold_n = SureHold(nominal, options, KnownSlope(senses));
  return std::max(options.least_pull_n, hold_n / options.peak);
}

}  // namespace dockyard::axel
