// Rocks as weather leaves them: faces whose edges are rounded, and hollows.
#pragma once

#include <cstdint>

#include "controller/geometry/pose.h"
#include "sim/rigid/star_body.h"

namespace dockyard {

/// On level ground z = 0. The target lies over the origin of plan: the point that is farthest out
/// along a normal, which the surface has there. It is the summit where that normal is vertical.
struct RoundedRockShape {
  double width_m = 0.6;          // mean of its length and width
  double target_up_m = 0.3;      // over the ground
  double face_up_rad = kPi / 2;  // of the target's normal over the horizontal
  double face_turn_rad = 0.0;    // of that normal in plan, from x
  double roughness_m = 1e-3;     // root mean square, of wavelengths of 12 to 100 mm
};

/// Same key, same rock.
StarBody MakeRoundedRock(const RoundedRockShape& shape, std::uint64_t key);

}  // namespace dockyard
