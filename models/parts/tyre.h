// A wheel's tyre on a firm floor: a cylinder or a ball that yields, grips and rolls with a loss.
#pragma once

namespace dockyard {

/// A tyre's bend b across its contact follows the slip while it rolls at the speed u of its
/// surface: db/dt = v - |u| b / relaxation, v the velocity of its surface on the floor; the force
/// is k b + c db/dt, at most friction x load. So steady rolling has the force k relaxation v / |u|,
/// that is the slip stiffness k relaxation (Pacejka, Tire and Vehicle Dynamics, 2012, section 7.2).
/// The bristles of a brush tyre with a contact of the length 2 a have the stiffness k = 2 a c
/// while it rests and the slip stiffness 2 a^2 c while it rolls (same book, section 3.2), so the
/// relaxation of a tyre with a stiff carcass is a.
struct TyreModel {
  double radius_m = 0.0;
  // Of the tread on the floor; 0: it touches in one point. That suits a caster: two points on a
  // light fork take the solver twice the time.
  double width_m = 0.0;
  // A sphere. A ball caster turns in its socket in all directions: its link stays as it is, and its
  // grip is the socket's drag over the load, over the floor's friction.
  bool ball = false;
  // Of the whole tyre against the floor; across it is as stiff (Mindlin 1949). Solid rubber:
  // assumed, 3e4-1e6 and 30-1000.
  double stiffness_n_per_m = 1e5, damping_ns_per_m = 100.0;
  double grip = 1.0;                   // factor on the floor's friction, 1 for rubber
  double rolling_resistance_m = 1e-3;  // on hard floor; assumed, 0.3-3 mm of solid rubber
  // Half the contact's length, sqrt(2 R x depth): 5 mm of a wheel of 60 mm with 0.2 mm; assumed,
  // 2-20 mm.
  double relaxation_m = 5e-3;
};

}  // namespace dockyard
