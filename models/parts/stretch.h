// A link's drawing and collision shapes grown along its axes.
#pragma once

#include <Eigen/Core>

#include "models/parts/link.h"

namespace dockyard {

/// Grows visuals and collision shapes about the link's origin by a factor along each of its axes.
/// Mass and inertia stay. False, with a link half grown, when a shape does not keep its kind: a
/// cylinder that would become elliptic, a box that would become slanted.
bool StretchShapes(LinkModel& link, const Eigen::Vector3d& factors);

}  // namespace dockyard
