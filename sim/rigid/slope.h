// The ground's plane against the vertical. The site frame G keeps its z axis normal to the plane,
// so soil, start and station are laid out as on level ground; gravity is what leans in G.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/pose.h"

namespace dockyard {

struct Slope {
  double angle_rad = 0.0;     // of the plane against the level, >= 0
  double downhill_rad = 0.0;  // the way down, from the site's x axis, counter-clockwise from above
};

/// The site in the world, whose z axis is up. X_WG: its origin, and its heading before it is
/// tilted.
Pose3 SiteInWorld(const Pose2& X_WG, const Slope& slope);
/// The site's axes in a frame with z up, with no heading of its own; the identity on level ground.
Eigen::Matrix3d Tilt(const Slope& slope);
/// Gravity in the site frame [m/s^2].
Eigen::Vector3d GravityInSite(const Slope& slope);

}  // namespace dockyard
