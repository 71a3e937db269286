// Paths of circular arcs for a rover that steers no faster than it drives: Nesnas, Maimone and Das
// (ICRA 2000), equations (1)-(3); (4)-(14) are in two_arcs.h. The driven point is the middle of the
// axle, so the paper's offset P of the point to place is zero unless given.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// Drive length_m along a circle (negative: backwards) while the heading turns by turn_rad.
/// A straight line turns by zero; length zero turns in place.
struct Arc {
  double length_m = 0.0;
  double turn_rad = 0.0;  // counter-clockwise from above

  bool operator==(const Arc&) const = default;
};

/// Pose at the end of the arc.
Pose2 Advance(const Pose2& X_AR, const Arc& arc);
Pose2 Advance(const Pose2& X_AR, const std::vector<Arc>& arcs);
/// The first part of an arc; share in [0, 1].
Arc Part(const Arc& arc, double share);
/// The first length_m of the path; the whole path if it is shorter.
std::vector<Arc> Truncate(const std::vector<Arc>& arcs, double length_m);
double Length(const std::vector<Arc>& arcs);   // distance travelled [m]
double Turning(const std::vector<Arc>& arcs);  // sum of absolute turns [rad]

/// The one arc that carries the point p_RP of the rover onto a goal given in the rover's frame;
/// Eqs. (2) and (3). A goal farther behind the axle than the point lies before it is reached
/// backwards. None for the point itself, which every turn would do, and for its mirror image
/// through the axle, which no turn reaches.
std::optional<Arc> OneArcTo(const Eigen::Vector2d& p_RG, const Eigen::Vector2d& p_RP);

}  // namespace dockyard
