#include "sim/vehicles/firm_ground.h"

namespace dockyard {

ContactMaterial MaterialOn(const FloorModel& floor, double stiffness_n_per_m,
                           double damping_ns_per_m, double grip) {
  ContactMaterial material{stiffness_n_per_m, damping_ns_per_m, grip * floor.friction, 0.0};
  if (floor.stiffness_n_per_m <= 0.0) return material;
  const double share = floor.stiffness_n_per_m / (stiffness_n_per_m + floor.stiffness_n_per_m);
  material.stiffness_n_per_m = share * stiffness_n_per_m;
  material.damping_ns_per_m =
      share * share * damping_ns_per_m + (1.0 - share) * (1.0 - share) * floor.damping_ns_per_m;
  return material;
}

}  // namespace dockyard
