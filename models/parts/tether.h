// A tether and the drum that it is wound on.
#pragma once

namespace dockyard {

/// Massless: it weighs nothing, and touches the station's edges alone. Cable: it weighs, lies on
/// the ground and on solids, and rubs there.
enum class TetherLaw { kMassless, kCable };

struct TetherModel {
  TetherLaw law = TetherLaw::kMassless;
  double axial_stiffness_n = 0.0;  // EA: tension per strain [N]
  double damping_ns_per_m = 0.0;   // of the whole exposed length
  double diameter_m = 0.0;
  double mass_kg_per_m = 0.0;
  double friction_on_station = 0.0;  // capstan friction where it bends round the station's edges
  // The cable's Coulomb friction on what else it touches.
  double friction_on_ground = 0.0;
  double friction_on_rock = 0.0;
  double friction_on_rover = 0.0;       // wheels and body
  double drum_radius_m = 0.0;           // at power-on
  double drum_growth_m_per_turn = 0.0;  // with every turn that is wound on
};

}  // namespace dockyard
