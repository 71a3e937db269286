// A firm floor under tyres and feet: how it rubs and yields, and its surface in images.
#pragma once

#include <cstdint>
#include <string>

namespace dockyard {

/// What a surface is made of, for its spectrum.
enum class GroundMaterialKind : std::uint8_t { kFloor, kSoil, kGrass, kBrick, kGrey };

struct FloorModel {
  std::string name, source;
  double friction = 0.0;  // of rubber on it (Coulomb)
  // Of what yields under one wheel or one foot, such as a carpet's pile and pad. 0: rigid, the
  // tyre alone yields.
  double stiffness_n_per_m = 0.0, damping_ns_per_m = 0.0;
  double rolling_resistance_m = 0.0;  // that it adds to a wheel's own
  GroundMaterialKind material = GroundMaterialKind::kFloor;
  double grain = 0.0;  // contrast of what lies on it, 0 to 1
};

}  // namespace dockyard
