// How near parts of a rover come to fixed things while the rover drives an arc. Exact.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/pose.h"
#include "controller/motion/arcs.h"

namespace dockyard {

/// Least distance [m] of the point p_AQ from a straight part of the rover, from p_RP to p_RE, while
/// the rover drives the arc from X_AR; 0 where the part passes over the point. Equal ends: a point
/// of the rover. Closed form: seen from the rover the point moves along a circle or a line.
double SweptDistance(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RP,
                     const Eigen::Vector2d& p_RE, const Eigen::Vector2d& p_AQ);

/// The same of the rover's point p_RQ from a fixed segment, from p_AP to p_AE.
double SweptDistanceOfPoint(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RQ,
                            const Eigen::Vector2d& p_AP, const Eigen::Vector2d& p_AE);

}  // namespace dockyard
