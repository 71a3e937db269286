// Boulders with flat faces, rough as broken rock is: planes cut out of a block, with a roughness
// that is alike at every scale.
#pragma once

#include <cstdint>

#include "sim/rigid/star_body.h"

namespace dockyard {

/// On level ground z = 0. The face that a tool is brought to holds the origin of plan.
struct BoulderShape {
  double width_m = 0.6;        // about, across
  double target_up_m = 0.3;    // height of the face's middle over the ground
  double face_up_rad = 0.5;    // of its outward normal over the horizontal
  double face_turn_rad = 0.0;  // of that normal in plan, from x
  // From the face's middle to its upper edge; a small one makes it a top.
  double rim_m = 0.1;
  double roughness_m = 1e-3;  // root mean square, of wavelengths of 12 to 100 mm
};

/// Same key, same boulder. The face's normal is exact but for the roughness, and no other face
/// reaches into the disc of 8 cm about its middle, but at its upper edge.
StarBody MakeBoulder(const BoulderShape& shape, std::uint64_t key);

/// The face's outward normal.
Eigen::Vector3d FaceNormal(const BoulderShape& shape);

}  // namespace dockyard
