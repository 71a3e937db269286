// How far a rover keeps from obstacles along a path of arcs: its true outline, its wheels steered
// as each arc asks. Exact up to the closed forms of arc_distance.h.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "controller/geometry/rover_plan.h"
#include "controller/motion/arcs.h"

namespace dockyard {

/// The rover's parts in R while it drives the arc: its body, and its wheels steered.
std::vector<Polygon> OutlineOn(const RoverPlan& rover, const Arc& arc);

/// The least distance [m] of the rover from an obstacle while it drives the arcs from R's start,
/// and while it steers its wheels between them. Where they overlap: 0 or less, and then its size is
/// a lower bound of how far the path must be moved to be free. No more than enough_m.
double Clearance(const RoverPlan& rover, const std::vector<Arc>& path, const Obstacles& obstacles,
                 double enough_m);

/// The same of the body alone, where R stands at X_AR.
double StandingClearance(const RoverPlan& rover, const Pose2& X_AR, const Obstacles& obstacles,
                         double enough_m);

}  // namespace dockyard
