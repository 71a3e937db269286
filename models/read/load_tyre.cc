#include "models/read/load_tyre.h"

namespace dockyard {

void VisitTyre(Keys& keys, TyreModel& tyre) {
  keys.Number({"radius_m", "m", "from the axle to the tread; 0: as the link's collision has it"},
              tyre.radius_m, NonNegative(2.0));
  keys.Number({"width_m", "m", "of the tread on the floor; 0: one point"}, tyre.width_m,
              NonNegative(2.0));
  keys.Bool({"ball", "", "whether it is a sphere"}, tyre.ball);
  keys.Number({"stiffness_n_per_m", "N/m", "force over the depth of its contact"},
              tyre.stiffness_n_per_m, Positive(1e9));
  keys.Number({"damping_ns_per_m", "N s/m", "force over the speed of its yielding"},
              tyre.damping_ns_per_m, NonNegative(1e7));
  keys.Number({"grip", "", "factor on the floor's friction of rubber"}, tyre.grip,
              NonNegative(3.0));
  keys.Number({"rolling_resistance_m", "m", "moment against rolling over the load, on hard floor"},
              tyre.rolling_resistance_m, NonNegative(0.1));
  keys.Number({"relaxation_m", "m", "how far it rolls while its bend follows the slip"},
              tyre.relaxation_m, Between(1e-4, 1.0));
  keys.Check("width_m", !tyre.ball || tyre.width_m == 0.0, "0 of a ball", NumberText(tyre.width_m));
}

}  // namespace dockyard
