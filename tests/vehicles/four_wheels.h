// A cart with four wheels of one kind, for tests of tyres.
#pragma once

#include <vector>

#include "vehicles/tyre_rig.h"

namespace dockyard {

inline constexpr double kWheel_m = 0.06, kBase_m = 0.3, kTrack_m = 0.3, kBody_kg = 15.0;

/// Four wheels at the corners, the rear ones driven or not; the body's frame is amid the axles, its
/// centre of mass as well.
inline CartPlan FourWheels(const TyreModel& tyre, bool driven = false) {
  CartPlan plan(BoxModel(kBody_kg, {0.4, 0.3, 0.1}));
  for (const double x : {0.5, -0.5}) {
    for (const double y : {0.5, -0.5}) {
      const Eigen::Vector3d p_m(x * kBase_m, y * kTrack_m, 0.0);
      if (driven && x < 0.0) {
        plan.AddDriven(0, p_m, tyre);
      } else {
        plan.AddWheel(0, p_m, tyre);
      }
    }
  }
  return plan;
}

inline Pose3 OnFloor() { return Pose3::Translation(0.0, 0.0, kWheel_m); }

/// Moves the cart forward without slip.
inline void SetRolling(Cart& cart, double speed_m_s) {
  std::vector<double> speeds{speed_m_s, 0, 0, 0, 0, 0};
  while (static_cast<long>(speeds.size()) < cart.tree().speeds().size()) {
    speeds.push_back(speed_m_s / kWheel_m);
  }
  SetSpeeds(cart.tree(), speeds);
}

}  // namespace dockyard
