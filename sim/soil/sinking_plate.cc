#include "sim/soil/sinking_plate.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {

SinkingPlate RoundPlate(const SoilModel& soil, double diameter_m) {
  const double radius_m = 0.5 * diameter_m, area_m2 = kPi * radius_m * radius_m;
  const SoilLaws laws = MakeRimLaws(soil, radius_m);
  return {area_m2 * laws.k, laws.n, area_m2 * laws.elastic_pa_per_m};
}

double DepthUnder(const SinkingPlate& plate, double force_n) {
  return std::pow(std::max(0.0, force_n) / plate.force_n_per_m_n, 1.0 / plate.n);
}

double PressPlate(const SinkingPlate& plate, double depth_m, double& sunk_m) {
  const double rebounding_n = plate.rebound_n_per_m * (depth_m - sunk_m);
  if (rebounding_n <= 0.0) return 0.0;
  const double bearing_n = plate.force_n_per_m_n * std::pow(depth_m, plate.n);
  if (rebounding_n <= bearing_n) return rebounding_n;
  sunk_m = depth_m - bearing_n / plate.rebound_n_per_m;
  return bearing_n;
}

}  // namespace dockyard
