// Cables for tests, and what may hang at their ends.
#pragma once

#include <cmath>
#include <string>

#include "models/parts/gravity.h"
#include "sim/cable/cable.h"

namespace dockyard {

inline constexpr double kG = kEarthGravity_m_s2;
inline const Eigen::Vector3d kDown(0.0, 0.0, -kG);

/// 6 mm, 50 g/m, EA 60 kN.
inline CableModel Cord() {
  return {.axial_stiffness_n = 6e4,
          .damping_ns_per_m = 200.0,
          .diameter_m = 0.006,
          .mass_kg_per_m = 0.05,
          .friction_on_ground = 0.5};
}

/// A weight or a hand at the cable's end: the same force always.
class ConstantEnd : public CableEnd {
 public:
  explicit ConstantEnd(const Eigen::Vector3d& force_G) : force_G_(force_G) {}
  CablePull Try(const Eigen::Vector3d&, const Eigen::Vector3d&, double) const override {
    return {force_G_, Eigen::Matrix3d::Zero()};
  }

 private:
  Eigen::Vector3d force_G_;
};
inline const ConstantEnd kLoose(Eigen::Vector3d::Zero());

}  // namespace dockyard
