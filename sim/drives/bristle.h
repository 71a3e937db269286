// Coulomb friction of a shaft that holds at rest: the bristle bends elastically up to the limit and
// slides there. Displacement, not speed, carries the load, so a resting shaft does not creep and
// does not chatter (elasto-plastic presliding: Dupont, Hayward, Armstrong and Altpeter, IEEE TAC
// 47(5), 2002).
#pragma once

#include <algorithm>

namespace dockyard {

struct ShaftBristle {
  double stiffness_nm_per_rad = 0.0;
  double damping_nms_per_rad = 0.0;  // of the bent bristle; the sum never exceeds the limit
  double limit_nm = 0.0;
};

/// Bends the bristle by one step and returns the torque that opposes the turning.
inline double BristleTorque(const ShaftBristle& bristle, double speed_rad_s, double dt_s,
                            double& bend_rad) {
  if (bristle.limit_nm <= 0.0) return 0.0;
  const double most = bristle.limit_nm / bristle.stiffness_nm_per_rad;
  bend_rad = std::clamp(bend_rad + speed_rad_s * dt_s, -most, most);
  const double torque =
      bristle.stiffness_nm_per_rad * bend_rad + bristle.damping_nms_per_rad * speed_rad_s;
  return -std::clamp(torque, -bristle.limit_nm, bristle.limit_nm);
}

}  // namespace dockyard
