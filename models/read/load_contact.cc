#include "models/read/load_contact.h"

namespace dockyard {

void VisitYield(Keys& keys, ContactMaterial& material, Presence needed) {
  keys.Number({"stiffness_n_per_m", "N/m", "force over the depth of a contact", needed},
              material.stiffness_n_per_m, Positive(1e10));
  keys.Number({"damping_ns_per_m", "N s/m", "force over the speed of its yielding", needed},
              material.damping_ns_per_m, NonNegative(1e8));
}

void VisitContact(Keys& keys, ContactMaterial& material, Presence needed) {
  VisitYield(keys, material, needed);
  keys.Number({"friction", "", "Coulomb's coefficient", needed}, material.friction,
              NonNegative(10.0));
  keys.Number({"rolling_resistance_m", "m", "moment against rolling over the normal force"},
              material.rolling_resistance_m, NonNegative(1.0));
}

void VisitStop(Keys& keys, JointStop& stop, Presence needed) {
  keys.Number({"stiffness_nm_per_rad", "N m/rad", "torque over the turn beyond the stop", needed},
              stop.stiffness_nm_per_rad, Positive(1e7));
  keys.Number({"damping_nms_per_rad", "N m s/rad", "torque over the rate of that turn", needed},
              stop.damping_nms_per_rad, NonNegative(1e5));
}

void VisitSlideStop(Keys& keys, JointStop& stop, Presence needed) {
  keys.Number({"stiffness_n_per_m", "N/m", "force over the travel beyond the stop", needed},
              stop.stiffness_nm_per_rad, Positive(1e9));
  keys.Number({"damping_ns_per_m", "N s/m", "force over the speed of that travel", needed},
              stop.damping_nms_per_rad, NonNegative(1e7));
}

}  // namespace dockyard
