// One belt alone over level ground at a set load, slip and side slip, to steady state: the rig of
// single-wheel tests, for belts.
#pragma once

#include "sim/vehicles/belt.h"

namespace dockyard {

struct BeltTrial {
  double load_n = 0.0;
  double slip = 0.0;           // (u - v) / max(|u|, |v|): u of the belt's surface, v of the travel
  double side_slip_rad = 0.0;  // from the belt's plane to its travel, to the right
  double speed_m_s = 0.1;      // of the faster of both
};

/// Means over whole pads.
struct BeltTrialResult {
  double drawbar_n = 0.0;  // along the belt; it pulls
  double side_n = 0.0;     // of the ground, to the left: against the side slip
  double carried_n = 0.0;  // the load that it bears
  double torque_nm = 0.0;  // that a motor must give the sprocket
  double sinkage_m = 0.0;  // of the lower run below the ground
  double contact_m = 0.0;  // length of the belt that touches
};

/// The belt's x and y are of `model`; its pads start as made.
BeltTrialResult RunBelt(const BeltModel& model, Belt belt, const BeltTrial& trial);

}  // namespace dockyard
