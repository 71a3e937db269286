// A single-wheel rig: a carriage drives one wheel at a set slip and side-slip angle under a fixed
// load, free to sink, until its forces are steady. The rig of `dockyard wheel` and of the tests;
// the soil is that of the rover.
#pragma once

#include "models/parts/soil_model.h"
#include "models/parts/wheel.h"

namespace dockyard {

struct SingleWheelSetup {
  WheelModel wheel;
  SoilModel soil;
  double load_n = 0.0;
  /// (w r - v) / max(|w r|, |v|) with the rim radius and the speed of travel, -1..1. At 1 the wheel
  /// turns on the spot, its rim at speed_m_s.
  double slip = 0.0;
  double side_slip_rad = 0.0;  // of the travel to the right of the wheel's plane
  double speed_m_s = 0.01;     // of travel, along the way, not in the wheel's plane
  double step_s = 1e-3;
  bool free_spin = false;  // towed: the spin follows from the soil's torque alone, slip is ignored
};

/// Means over whole paddle pitches of the steady state; forces of the soil on the wheel.
struct SingleWheelResult {
  double ahead_n = 0.0;    // in the wheel's heading: drawbar > 0, resistance < 0
  double side_n = 0.0;     // against a side slip, positive for a positive one
  double up_n = 0.0;       // the load, when steady
  double torque_nm = 0.0;  // what a motor must give; driving > 0
  double sinkage_m = 0.0;  // of the paddles' tips, or of the smooth rim
  double slip = 0.0;       // as set, or of the towed wheel
  double height_rms_m = 0.0, ahead_rms_n = 0.0;  // about the means
  double travel_m = 0.0;
  long steps = 0;
  bool steady = false;  // false: it was still changing after the longest way
};

/// Runs until the means over one rim radius of way (of whole paddle pitches) change by less than
/// 0.4 % of the load and of the radius, three times on end; at most over 60 radii.
SingleWheelResult RunSingleWheel(const SingleWheelSetup& setup);

}  // namespace dockyard
