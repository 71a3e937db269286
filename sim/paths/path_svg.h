// A planned path as a drawing.
#pragma once

#include <string>

#include "sim/paths/planned_path.h"

namespace dockyard {

/// From above: candidates, obstacles, the path, the rover where each arc begins and ends; below
/// that the wheels' steering angles along the path.
std::string PathSvg(const PathTask& task, const PlannedPath& plan);

}  // namespace dockyard
