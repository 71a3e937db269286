// Soil parameters, SI. Pressure after Bekker: p = (k_c / b + k_phi) z^n, b the plate's smaller
// side. Shear after Janosi and Hanamoto: tau = (c + p tan phi)(1 - exp(-j / K)).
// docs/reference/soil.md has the laws.
#pragma once

#include <Eigen/Core>
#include <string>

#include "models/parts/gravity.h"

namespace dockyard {

struct SoilModel {
  std::string name;
  std::string source;           // of the numbers
  double n = 1.0;               // sinkage exponent [-]
  double slip_weakening = 0.0;  // 0: sliding costs no bearing; 1: as in the loose sand measured
  double k_c = 0.0;             // [N/m^(n+1)]
  double k_phi = 0.0;           // [N/m^(n+2)]
  // Where plates of several widths were pressed in and bore in proportion to their width: k_phi is
  // the narrowest plate's, and grows up to the widest's. Zero where they were not.
  double narrowest_plate_m = 0.0, widest_plate_m = 0.0;
  double cohesion_pa = 0.0;
  double friction_angle_rad = 0.0;
  double shear_modulus_m = 0.0;  // K [m] of a contact of the next line's depth
  double shear_depth_m = 0.015;
  double density_kg_m3 = 0.0;
  double unloading_stiffness_pa_per_m = 0.0;  // elastic rebound of loaded soil
  double damping_pa_s_per_m = 0.0;            // bounded normal damping, never suction
  // Where the soil lies. Weight, moduli, rebound and damping above are those on Earth, and go with
  // it: grains under less weight bear and rebound less (Kobayashi et al., J. Terramech. 47, 2010).
  double gravity_m_s2 = kEarthGravity_m_s2;
  Eigen::Vector3d rgb{0.5, 0.4, 0.3};  // linear albedo, for drawing
};

}  // namespace dockyard
