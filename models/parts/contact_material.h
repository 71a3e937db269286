// How two surfaces yield and rub where they touch.
#pragma once

namespace dockyard {

/// One point of contact of a pair of surfaces. It yields across its normal as along it (Mindlin
/// 1949).
struct ContactMaterial {
  double stiffness_n_per_m = 0.0;     // > 0
  double damping_ns_per_m = 0.0;      // of both directions
  double friction = 0.0;              // Coulomb's
  double rolling_resistance_m = 0.0;  // moment against rolling per normal force
};

}  // namespace dockyard
