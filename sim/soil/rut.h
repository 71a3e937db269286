// The track of a wheel: the pressed floor of its rut, and berms of the soil that it displaced.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/soil/height_grid.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {

/// The rim as it stands on the ground, in the site frame G.
struct RimPlace {
  Eigen::Vector3d p_G{0, 0, 0};     // centre [m]
  Eigen::Vector3d axis_G{0, 1, 0};  // unit, to the wheel's left
  double radius_m = 0.0, width_m = 0.0;
  double reach_m = 0.0;  // half length of the contact, seen from above
};

struct GridSample {
  int ix = 0, iy = 0;
};

/// Soil that slides from one sample to a neighbour.
struct SoilFlow {
  double *from = nullptr, *to = nullptr;
  double moved_m = 0.0;  // of height; negative: the other way
};

/// Working memory, so that a rut allocates nothing once it is warm.
struct RutScratch {
  std::vector<GridSample> inside;  // those that reached into the rim when it pressed last
  std::vector<unsigned char> under_wheel;
  std::vector<SoilFlow> flows;
};

/// Presses the grid's samples under the rim to where the soil carries it, counted from the surface
/// less what paddles have carried away (excavated_m), and moves the displaced volume to both sides
/// of the rut. A second call changes nothing. Returns the volume moved [m^3].
double PressRut(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double excavated_m,
                RutScratch& scratch);

/// Lets slopes steeper than the friction angle slump beside and behind the wheel for dt, but not
/// where the rim stands since it pressed last. Conserves volume.
void SlumpBeside(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double dt_s,
                 RutScratch& scratch);

}  // namespace dockyard
