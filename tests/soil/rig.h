// A single-wheel test rig: the carriage drives a wheel at a set speed, spin and side-slip angle;
// the wheel is free to sink under a set load.
#pragma once

#include "sim/soil/wheel_soil.h"

namespace dockyard::soil_test {

struct RigSetup {
  WheelModel wheel;
  SoilModel soil;
  double load_n = 0.0;
  double speed_m_s = 0.0;      // of the carriage
  double rim_speed_m_s = 0.0;  // at the rim radius, without the paddles
  double side_slip_rad = 0.0;  // the carriage goes this far to the wheel's left
  double travel_m = 0.0;
  double cell_m = 0.005;
  double step_s = 1e-3;
  bool free_spin = false;  // towed: the spin follows from the soil's torque alone
};

/// Means over the last part of the travel; forces of the soil on the wheel in the wheel's heading.
struct RigResult {
  double ahead_n = 0.0, left_n = 0.0, up_n = 0.0;
  double torque_nm = 0.0;  // about the axle, forward positive
  double sinkage_m = 0.0;  // of the lowest point of rim or paddle, turned or not
  double rim_speed_m_s = 0.0;
  double height_rms_m = 0.0;  // axle height about its mean
  double ahead_rms_n = 0.0;
};

RigResult RunRig(const RigSetup& setup);

/// Soils and wheels of the tests, with their sources.
SoilModel PavlovSand();
SoilModel WongDrySand();
SoilModel CompactGranite();
WheelModel PavlovWheel(bool paddled);
WheelModel AxelWheel(int paddle_count);

}  // namespace dockyard::soil_test
