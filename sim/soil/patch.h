// One small piece of a wheel's surface in the soil: its state and its load.
#pragma once

#include "sim/soil/height_grid.h"
#include "sim/soil/soil_laws.h"
#include "sim/soil/wheel_frame.h"
#include "sim/soil/wheel_travel.h"

namespace dockyard {

constexpr double kNoFloor_m = 1e9;

/// The state of a patch while it is in the soil.
struct Patch {
  Mobilisation shear;
  double into = 1.0;            // direction cosine of its way with its inward normal
  double ride_m = 0.0;          // change of the floor by sliding along the patch's plane
  double floor_m = kNoFloor_m;  // height at which the soil under this patch ends its rebound
};

/// A patch over the soil, and its motion along its spoke's axes (r into the soil).
struct PatchPlace {
  double z_m = 0.0, surface_m = 0.0, undisturbed_m = 0.0;
  SpokeVelocity v;
  double climb_m_s = 0.0;  // of its sliding along its own plane

  double sinkage_m() const { return undisturbed_m - z_m; }

  /// Soil caught between the paddles bears at radius_m, but slides along the rim under it.
  PatchPlace(const HeightGrid& grid, const WheelFrame& frame, const SpokeAxes& axes,
             double radius_m, double y_m, double sliding_radius_m)
      : v(VelocityAt(axes, sliding_radius_m, y_m)), climb_m_s(v.t * axes.t_z + v.a * axes.a_z) {
    const Eigen::Vector3d p_G = frame.p_G + radius_m * axes.r_G + y_m * frame.y_G;
    const GridCell cell = CellAt(grid, p_G.x(), p_G.y());
    z_m = p_G.z();
    surface_m = Interpolate(grid, grid.heights_m, cell);
    undisturbed_m = Interpolate(grid, grid.undisturbed_m, cell);
  }
};

/// Advances the patch by dt and gives the soil's load on it: pressure on its normal, elastic from
/// the rut's floor and yielding at the pressure that its depth and direction allow; shear by its
/// way since it entered, over lengths in proportion to the contact's depth.
SpokeLoad LoadPatch(const SoilLaws& laws, const WheelTravel& travel, double contact_depth_m,
                    const PatchPlace& at, double area_m2, double dt_s, Patch& patch);

}  // namespace dockyard
