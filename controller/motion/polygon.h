// Areas with straight sides. Polygon is in rover_plan.h.
#pragma once

#include "controller/geometry/pose.h"
#include "controller/geometry/rover_plan.h"

namespace dockyard {

/// Calls look with the ends of each side.
template <class Look>
void ForEachSide(const Polygon& polygon, const Look& look) {
  for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
    look(polygon[last], polygon[i]);
  }
}

Polygon Moved(const Pose2& X_AB, const Polygon& polygon_B);
bool Contains(const Polygon& polygon, const Eigen::Vector2d& p);
Eigen::Vector2d MeanCorner(const Polygon& polygon);
/// Distance of the point from the nearest side [m]: positive within, negative without.
double DepthIn(const Polygon& polygon, const Eigen::Vector2d& p);

/// A wheel's outline about its middle, as it points along x.
Polygon WheelOutline(const RoverPlan& rover);

}  // namespace dockyard
