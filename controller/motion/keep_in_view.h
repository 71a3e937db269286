// Whether a target stays in a camera's view while a rover drives. Exact.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "controller/geometry/rover_plan.h"
#include "controller/motion/arcs.h"

namespace dockyard {

/// The least distance [m] of the target from the border of what the camera sees of the ground,
/// while the rover drives the arcs from R's start; negative where the target leaves the view.
double SpareInView(const ViewPlan& view, const std::vector<Arc>& path, const Eigen::Vector2d& p_AT);

}  // namespace dockyard
