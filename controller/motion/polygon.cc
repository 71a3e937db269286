#include "controller/motion/polygon.h"

#include <algorithm>
#include <limits>

#include "controller/motion/circle_way.h"

namespace dockyard {

using Eigen::Vector2d;

Polygon Moved(const Pose2& X_AB, const Polygon& polygon_B) {
  Polygon moved;
  for (const Vector2d& corner : polygon_B) moved.push_back(X_AB * corner);
  return moved;
}

// Even-odd rule: a ray to the right crosses the sides an odd number of times.
bool Contains(const Polygon& polygon, const Vector2d& p) {
  bool inside = false;
  ForEachSide(polygon, [&](const Vector2d& a, const Vector2d& b) {
    if ((a.y() > p.y()) == (b.y() > p.y())) return;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
  });
  return inside;
}

Vector2d MeanCorner(const Polygon& polygon) {
  Vector2d sum(0, 0);
  for (const Vector2d& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

double DepthIn(const Polygon& polygon, const Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  ForEachSide(polygon, [&](const Vector2d& a, const Vector2d& b) {
    least = std::min(least, ToSegment(p, a, b));
  });
  return Contains(polygon, p) ? least : -least;
}

Polygon WheelOutline(const RoverPlan& rover) {
  const double x = rover.wheel_radius_m, y = 0.5 * rover.wheel_width_m;
  return {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
}

}  // namespace dockyard
