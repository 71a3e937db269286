// What a controller believes at a sample of a logged run, in words.
#pragma once

#include <cstddef>
#include <string>

#include "sim/log/logged_run.h"

namespace dockyard {

/// The pose of the robot where the controller has one; else where the target is, from the robot's
/// place in plan: by the belief's values `target_x_m` (ahead) and `target_y_m` (to the left), or
/// by the last accepted sighting; with the time that it is of, where it is older. "not located"
/// without any of these; both values 0: none yet. Empty for a log without a belief.
std::string BelievedWords(const LoggedRun& run, std::size_t sample);

/// "x 1.20 m, y 0.30 m, heading 4.0 deg", of `x_m`, `y_m` and `heading_rad`; 0 for those missing.
std::string PoseWords(const Series& series, std::size_t sample);

}  // namespace dockyard
