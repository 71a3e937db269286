// A belt round two rollers, and the ground as it meets belts.
//
// A reader of YAML would name the keys as the fields here, angles in degrees: front and rear with
// x_m, z_m, radius_m; y_m, width_m, pads, sprocket_radius_m, stiffness_pa_per_m,
// damping_pa_s_per_m, shear_stiffness_pa_per_m, shear_damping_pa_s_per_m; of a ground friction (or
// friction_angle_deg), lateral_ratio, cohesion_pa, shear_displacement_m, rolling_loss.
#pragma once

namespace dockyard {

/// An axle along y, in the frame of the link that carries it. The radius is to the belt's outside.
struct Roller {
  double x_m = 0.0, z_m = 0.0, radius_m = 0.0;
};

/// A belt round two rollers, all in the frame of the link that carries it: x forward, y along the
/// axles to the left, z up. A positive belt speed drives the link forward where the lower run
/// bears.
struct BeltModel {
  Roller front, rear;
  double y_m = 0.0;  // of the belt's middle
  double width_m = 0.0;
  int pads = 0;                    // equal pieces round the belt
  double sprocket_radius_m = 0.0;  // to the belt's outside
  // Of rubber and floor, per area that touches: along the normal, where the ground never pulls,
  // and along the ground.
  double stiffness_pa_per_m = 0.0, damping_pa_s_per_m = 0.0;
  double shear_stiffness_pa_per_m = 0.0, shear_damping_pa_s_per_m = 0.0;
};

/// A ground that carries belts without sinking.
struct BeltGround {
  double friction = 0.0;       // longitudinal; tan(phi) of soil
  double lateral_ratio = 1.0;  // lateral friction over longitudinal
  double cohesion_pa = 0.0;    // counts up to the pressure, as in soil_laws.h
  // K of Janosi and Hanamoto (1961). 0: firm, the belt's own shear alone comes before sliding.
  double shear_displacement_m = 0.0;
  double rolling_loss = 0.0;  // force to move the belt round under load, over the load
  // Its strength differs from place to place: factors uniform in 1 -+ this, in square patches.
  double patch_scatter = 0.0, patch_m = 0.2;
};

/// Vinyl or concrete under a rubber belt. Assumed: friction 0.4-0.9, lateral ratio 0.8-1.2, rolling
/// loss 0.02-0.08.
inline constexpr BeltGround kHardFloor{.friction = 0.6, .rolling_loss = 0.04};

/// Grass on loam: friction angle 32 deg. Assumed: 28-38 deg, cohesion 1-8 kPa, K 10-40 mm, rolling
/// loss 0.06-0.15.
inline constexpr BeltGround kGrass{
    .friction = 0.6249, .cohesion_pa = 3e3, .shear_displacement_m = 0.020, .rolling_loss = 0.10};

}  // namespace dockyard
