// The soil beside a wheel that goes sideways: it is bulldozed, and rubs along the wheel's side.
#pragma once

#include "sim/soil/soil_laws.h"
#include "sim/soil/wheel_frame.h"

namespace dockyard {

/// Way of the side of one strip through the soil, remembered over the contact's K: the
/// direction of motion along the spoke's axes, a vector of length <= 1.
struct SideWall {
  double r = 0.0, t = 0.0, a = 0.0;
};

/// The strip's side at the depth of the rim's edge that leads.
struct SideStrip {
  double radius_m = 0.0, half_width_m = 0.0;
  double length_m = 0.0;                           // along the rim
  double depth_right_m = 0.0, depth_left_m = 0.0;  // of the rim's edges
};

/// Advances the wall by dt and adds its load to the sum.
void AddSideWall(const SoilLaws& laws, double contact_depth_m, const SpokeAxes& axes,
                 const SideStrip& strip, double dt_s, SideWall& wall, LoadSum& sum);

}  // namespace dockyard
