// One small piece of a wheel's surface in the soil: its state and its load.
#pragma once

#include <type_traits>

#include "sim/soil/height_grid.h"
#include "sim/soil/soil_laws.h"
#include "sim/soil/wheel_frame.h"
#include "sim/soil/wheel_travel.h"

namespace dockyard {

constexpr double kNoFloor_m = 1e9;

/// The state of a patch while it is in the soil; of four patches for Four.
template <typename Real>
struct PatchOf {
  MobilisationOf<Real> shear;
  Real into = 1.0;            // direction cosine of its way with its inward normal
  Real ride_m = 0.0;          // change of the floor by sliding along the patch's plane
  Real floor_m = kNoFloor_m;  // height at which the soil under this patch ends its rebound
};
using Patch = PatchOf<double>;

/// Gives `to` the state `from` where the mask is set.
template <typename Real>
void Put(std::type_identity_t<decltype(Real(0.0) > 0.0)> where, const PatchOf<Real>& from,
         PatchOf<Real>& to) {
  to.shear.t = Select(where, from.shear.t, to.shear.t);
  to.shear.a = Select(where, from.shear.a, to.shear.a);
  to.into = Select(where, from.into, to.into);
  to.ride_m = Select(where, from.ride_m, to.ride_m);
  to.floor_m = Select(where, from.floor_m, to.floor_m);
}

/// A patch over the soil.
template <typename Real>
struct PatchHeightOf {
  Real z_m = 0.0, surface_m = 0.0, undisturbed_m = 0.0;

  Real sinkage_m() const { return undisturbed_m - z_m; }

  PatchHeightOf(const GroundUnder& ground, const WheelFrame& frame, const SpokeAxesOf<Real>& axes,
                double radius_m, std::type_identity_t<Real> y_m)
      : z_m(frame.p_G.z() + y_m * frame.y_G.z() + radius_m * axes.r_z) {
    ground.Read(frame.p_G.x() + y_m * frame.y_G.x() + radius_m * axes.r_x,
                frame.p_G.y() + y_m * frame.y_G.y() + radius_m * axes.r_y, surface_m,
                undisturbed_m);
  }
};

/// A patch over the soil, and its motion along its spoke's axes (r into the soil).
template <typename Real>
struct PatchPlaceOf : PatchHeightOf<Real> {
  SpokeVelocityOf<Real> v;
  Real climb_m_s = 0.0;  // of its sliding along its own plane

  /// Soil caught between the paddles bears at its own radius, but slides along the rim under it.
  PatchPlaceOf(const PatchHeightOf<Real>& height, const SpokeAxesOf<Real>& axes,
               double sliding_radius_m, std::type_identity_t<Real> y_m)
      : PatchHeightOf<Real>(height),
        v(VelocityAt(axes, sliding_radius_m, y_m)),
        climb_m_s(v.t * axes.t_z + v.a * axes.a_z) {}
  PatchPlaceOf(const GroundUnder& ground, const WheelFrame& frame, const SpokeAxesOf<Real>& axes,
               double radius_m, std::type_identity_t<Real> y_m, double sliding_radius_m)
      : PatchPlaceOf({ground, frame, axes, radius_m, y_m}, axes, sliding_radius_m, y_m) {}
};
using PatchPlace = PatchPlaceOf<double>;

/// Advances the patch by dt and gives the soil's load on it: pressure on its normal, elastic from
/// the rut's floor and yielding at the pressure that its depth and direction allow; shear by its
/// way since it entered, over lengths in proportion to the contact's depth. For double and Four.
template <typename Real>
SpokeLoadOf<Real> LoadPatch(const SoilLaws& laws, const WheelTravel& travel, double contact_depth_m,
                            const PatchPlaceOf<Real>& at, double area_m2, double dt_s,
                            PatchOf<Real>& patch);

}  // namespace dockyard
