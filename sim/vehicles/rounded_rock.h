// Rocks as weather leaves them: faces whose edges are rounded, hollows, and a summit.
#pragma once

#include <cstdint>

#include "sim/rigid/star_body.h"

namespace dockyard {

/// On level ground z = 0. The summit lies over the origin of plan.
struct RoundedRockShape {
  double width_m = 0.6;       // mean of its length and width
  double summit_up_m = 0.3;   // over the ground
  double roughness_m = 1e-3;  // root mean square, of wavelengths of 12 to 100 mm
};

/// Same key, same rock.
StarBody MakeRoundedRock(const RoundedRockShape& shape, std::uint64_t key);

}  // namespace dockyard
