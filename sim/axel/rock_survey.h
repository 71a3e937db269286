// The controller's map of rocks, as a survey of the yard gives it.
#pragma once

#include "controller/axel/nominal/rock_map.h"
#include "controller/geometry/pose.h"
#include "sim/axel/axel_keys.h"
#include "sim/axel/rock_bed.h"
#include "sim/base/random.h"
#include "sim/soil/height_grid.h"

namespace dockyard::axel {

/// The given map, or one of the bed's rocks that are at least so high: each by the least disc about
/// its middle that holds it, its place with errors of sigma_m from the run's stream "rock_map".
/// Empty unless the keys ask for one. In the dock's frame D.
RockMap RockMapOf(const RockMapKeys& keys, const RockBed& bed, const HeightGrid& ground,
                  const Pose2& X_GD, const Seed& run_seed);

}  // namespace dockyard::axel
