// Bound on what a wheel's paddles push: the strength of the soil that they push against.
//
// The soil fails along the surface that the paddles' tips draw, the envelope. Along it friction
// carries what presses on rim and tips, and cohesion counts once. Behind the last paddle one
// passive wedge resists. The faces have of this what rim and tips do not take already.
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/soil/soil_laws.h"

namespace dockyard {

/// Sums over one wheel in one step [N]. Thrusts are along the wheel's turn.
struct Envelope {
  double pressed_n = 0.0;       // on rim and tips, normal
  double rim_and_tips_n = 0.0;  // their thrust by shear
  double faces_n = 0.0;         // the faces' thrust, were the soil behind them firm
};

/// What soil around a wheel can give to push against [N]: tan(phi) times what presses, cohesion
/// over the envelope's arc in the soil, and Rankine's passive wedge 1/2 gamma z^2 N_phi.
inline double EnvelopeStrength(const SoilLaws& laws, double pressed_n, double tip_radius_m,
                               double width_m, double sinkage_m) {
  const double arc_m = tip_radius_m * std::acos(std::max(-1.0, 1.0 - sinkage_m / tip_radius_m));
  const double wedge_pa_m = 0.5 * laws.passive_pa_per_m * sinkage_m * sinkage_m;
  return laws.tan_phi * pressed_n + width_m * (laws.cohesion_pa * arc_m + wedge_pa_m);
}

/// Share of the faces' thrust F that the soil gives when it has R left for them: R / (F + R). Two
/// resistances that yield one after the other, a hyperbola to the bound R (Kondner 1963).
inline double FaceShare(const Envelope& sum, double strength_n) {
  const double taken_n = std::copysign(1.0, sum.faces_n) * sum.rim_and_tips_n;
  const double left_n = strength_n - taken_n;
  return left_n > 0.0 ? left_n / (std::fabs(sum.faces_n) + left_n) : 0.0;
}

}  // namespace dockyard
