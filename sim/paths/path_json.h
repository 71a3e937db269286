// A planned path as JSON.
#pragma once

#include <string>
#include <vector>

#include "sim/base/json.h"
#include "sim/paths/planned_path.h"

namespace dockyard {

/// `feasible`, `arcs` with `length_m` and `turn_rad`, `cost_m`, `candidates`; of a rover with
/// wheels each arc has its `wheels`: `steer_rad`, `way_m` and `side_slip_rad` by name. `warnings`.
Json PathJson(const PathTask& task, const PlannedPath& plan,
              const std::vector<std::string>& warnings = {});

}  // namespace dockyard
