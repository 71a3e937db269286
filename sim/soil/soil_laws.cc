#include "sim/soil/soil_laws.h"

#include <algorithm>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Elastic soil under a strip deflects in proportion to the strip's width, so its stiffness per area
// grows as the strip narrows; the cap keeps 1 ms steps stable. Assumed, range 4-16.
constexpr double kTipStiffening = 8.0;

/// Pressure under a plate of this width over the narrowest measured plate's at the same depth.
double WidthFactor(const SoilModel& soil, double width_m) {
  if (soil.narrowest_plate_m == 0.0) return 1.0;
  return std::clamp(width_m, soil.narrowest_plate_m, soil.widest_plate_m) / soil.narrowest_plate_m;
}

}  // namespace

SoilLaws MakeRimLaws(const SoilModel& soil, double plate_width_m) {
  DOCKYARD_CHECK(plate_width_m > 0.0 && soil.shear_modulus_m > 0.0 && soil.shear_depth_m > 0.0 &&
                 soil.unloading_stiffness_pa_per_m > 0.0);
  const double phi = soil.friction_angle_rad;
  const double gamma = soil.density_kg_m3 * soil.gravity_m_s2;
  const double weight = soil.gravity_m_s2 / kEarthGravity_m_s2;
  SoilLaws laws;
  laws.k = weight * (soil.k_c / plate_width_m + WidthFactor(soil, plate_width_m) * soil.k_phi);
  laws.n = soil.n;
  laws.weakening = soil.slip_weakening;
  laws.elastic_pa_per_m = weight * soil.unloading_stiffness_pa_per_m;
  laws.damping_pa_s_per_m = weight * soil.damping_pa_s_per_m;
  laws.cohesion_pa = soil.cohesion_pa;
  laws.tan_phi = std::tan(phi);
  laws.tan_rim = std::tan(kWallFriction * phi);
  laws.shear_over_depth = soil.shear_modulus_m / soil.shear_depth_m;
  laws.sqrt_n_phi = std::tan(0.25 * kPi + 0.5 * phi);
  const double n_phi = laws.sqrt_n_phi * laws.sqrt_n_phi;
  laws.passive_pa_per_m = gamma * n_phi;
  laws.passive_pa = 2.0 * soil.cohesion_pa * laws.sqrt_n_phi;
  laws.bulldoze_n_per_m3 = 0.5 * gamma * n_phi * (1.0 + 0.5 * laws.sqrt_n_phi * laws.tan_phi);
  return laws;
}

SoilLaws MakeTipLaws(const SoilModel& soil, double thickness_m, double width_m) {
  SoilLaws laws = MakeRimLaws(soil, width_m);
  laws.elastic_pa_per_m *= std::clamp(width_m / thickness_m, 1.0, kTipStiffening);
  // Bearing strength of a strip (Terzaghi 1943 with Prandtl's and Reissner's factors):
  // c N_c + gamma z N_q, N_q = exp(pi tan phi) tan^2(45 deg + phi/2), N_c = (N_q - 1) cot phi.
  laws.plate_over_blade = std::max(1.0, width_m / thickness_m);
  const double n_q = std::exp(kPi * laws.tan_phi) * laws.sqrt_n_phi * laws.sqrt_n_phi;
  const double n_c = laws.tan_phi > 1e-6 ? (n_q - 1.0) / laws.tan_phi : 2.0 + kPi;
  laws.blade_strength_pa = soil.cohesion_pa * n_c;
  laws.blade_strength_pa_m = soil.density_kg_m3 * soil.gravity_m_s2 * n_q;
  return laws;
}

}  // namespace dockyard
