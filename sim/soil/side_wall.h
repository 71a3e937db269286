// The soil beside a wheel that goes sideways: it is bulldozed, and rubs along the wheel's side.
#pragma once

#include "sim/soil/soil_laws.h"
#include "sim/soil/wheel_frame.h"

namespace dockyard {

/// Way of the sides of four strips through the soil, remembered over the contact's K: the
/// direction of motion along the spokes' axes, vectors of length <= 1.
struct SideWalls {
  Four r = 0.0, t = 0.0, a = 0.0;
};

/// Four strips' sides at the depth of the rim's edge that leads.
struct SideStrips {
  double radius_m = 0.0, half_width_m = 0.0;
  double length_m = 0.0;                         // along the rim
  Four depth_right_m = 0.0, depth_left_m = 0.0;  // of the rim's edges
};

/// Advances the walls in the soil by dt and adds their loads to the sum; forgets the others.
void AddSideWalls(const SoilLaws& laws, double contact_depth_m, const SpokeAxesOf<Four>& axes,
                  const SideStrips& strips, FourMask in_soil, double dt_s, SideWalls& walls,
                  LoadSumOf<Four>& sum);

}  // namespace dockyard
