#include "controller/axel/excursion.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {

double FallBySeatedArm(const Nominal& nominal, double elevation_rad) {
  return elevation_rad - std::asin(nominal.X_DB.R.col(2).z());
}

double OutwardTension(const AxelOptions& options, double fall_rad) {
  const double downhill_n = options.noise.weight_n * std::sin(std::max(0.0, fall_rad));
  return options.tether.reverse_tension_n + options.excursion.weight_share * downhill_n;
}

double UndockedWay(const Nominal& nominal, const ExcursionOptions& options) {
  return nominal.seat_depth_m + options.clear_gap_m;
}

double WayOut(double paid_out_m, double rolled_back_m) {
  return std::min(paid_out_m, rolled_back_m);
}

double WayBack(double way_out_m, const ExcursionOptions& options) {
  return std::max(0.0, way_out_m - options.return_m);
}

}  // namespace dockyard::axel
