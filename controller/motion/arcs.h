// Paths of circular arcs for a rover that steers no faster than it drives: Nesnas, Maimone and Das
// (ICRA 2000), equations (1)-(14). The driven point is the middle of the axle, so the paper's
// offset P of the point to place is zero unless given.
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

/// The pair of arcs to a pose in the rover's frame whose first arc has the given curvature [1/m];
/// Eqs. (7) and (12) written for curvatures, so that straight parts are not special. None when the
/// pair needs a turn in place or more than half a circle in one arc.
std::optional<std::vector<Arc>> TwoArcsTo(const Pose2& X_RG, double first_curvature);

/// The cost of Eq. (14): |l1| + |l2| + ||l1| - |l2|| [m]; for a single arc its length twice.
double TwoArcCost(const std::vector<Arc>& arcs);

/// First curvatures worth trying, symmetric about zero, sharpest +-max_curvature.
std::vector<double> CurvatureFan(double max_curvature, int per_side);

/// The pair with the least TwoArcCost among a fan of curvatures, no arc sharper than
/// max_curvature. direction +1: forward only, -1: backward only, 0: either in each arc.
std::optional<std::vector<Arc>> CheapestTwoArcs(const Pose2& X_RG, double max_curvature,
                                                int direction);

}  // namespace dockyard
