// A tether and the drum that it is wound on.
#pragma once

namespace dockyard {

struct TetherModel {
  double axial_stiffness_n = 0.0;  // EA: tension per strain [N]
  double damping_ns_per_m = 0.0;   // of the whole exposed length
  double diameter_m = 0.0;
  double mass_kg_per_m = 0.0;
  double friction_on_station = 0.0;     // capstan friction where it bends round the station's edges
  double drum_radius_m = 0.0;           // at power-on
  double drum_growth_m_per_turn = 0.0;  // with every turn that is wound on
};

}  // namespace dockyard
