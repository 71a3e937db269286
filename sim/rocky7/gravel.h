// Gravel about the target: stones too small for wheels and scoops to meet them one by one, which
// the soil's laws have in them, but large enough for a stereo pair to detect them.
#pragma once

#include <vector>

#include "sim/rigid/convex_body.h"
#include "sim/rocky7/rocky7_keys.h"
#include "sim/soil/height_grid.h"

namespace dockyard::rocky7 {

/// As dense as the field's rocks, by the same law, from keys.gravel_m to the least of them, within
/// keys.gravel_within_m of the origin of D; in D, on this ground. None lies under the target or
/// under one of the stones. Throws std::length_error as PlaceRocks.
std::vector<ConvexBody> GravelAbout(const Rocky7Keys& keys, const RockField& rocks,
                                    const HeightGrid& ground,
                                    const std::vector<ConvexBody>& stones_G, const Seed& seed);

}  // namespace dockyard::rocky7
