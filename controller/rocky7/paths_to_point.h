// Arcs that bring a point of the rover onto a place of the ground.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/rover_plan.h"
#include "controller/motion/two_arcs.h"

namespace dockyard::rocky7 {

/// What the wheels steer, but no turn in place: it slips, and loads the mechanism (Nesnas, Maimone
/// and Das, III-B).
ArcLimits GentleLimits(const RoverPlan& plan);

/// The arc, no sharper than the wheels steer; its length stays.
Arc NoSharper(const Arc& arc, const ArcLimits& limits);

/// Arcs that bring the point p_RP onto a goal in R: one where the limits let it, else a first arc
/// of 0.09 to 0.6 m and a second one, the shortest such, else with a shorter first one; none where
/// there is none.
std::vector<Arc> ArcsToPoint(const Eigen::Vector2d& p_RG, const Eigen::Vector2d& p_RP,
                             const ArcLimits& limits);

/// As ArcsToPoint, by gentle arcs where these lead there: sharp ones turn standing wheels far,
/// which pushes the rover aside.
std::vector<Arc> GentleArcsToPoint(const Eigen::Vector2d& p_RG, const RoverPlan& plan);

}  // namespace dockyard::rocky7
