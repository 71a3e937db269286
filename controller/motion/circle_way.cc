#include "controller/motion/circle_way.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double ToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double squared = ab.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * ab).norm();
}

Eigen::Vector2d CircleWay::End() const {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  const Eigen::Vector2d v = from - centre;
  return centre + Eigen::Vector2d(c * v.x() - s * v.y(), s * v.x() + c * v.y());
}

bool CircleWay::Passes(const Eigen::Vector2d& direction) const {
  if (std::abs(turn_rad) >= 2.0 * kPi) return true;
  const Eigen::Vector2d v = from - centre;
  double angle = std::atan2(Cross(v, direction), v.dot(direction));
  if (turn_rad < 0.0) angle = -angle;
  if (angle < 0.0) angle += 2.0 * kPi;
  return angle <= std::abs(turn_rad);
}

double CircleWay::DistanceTo(const Eigen::Vector2d& p) const {
  const double ends = std::min((p - from).norm(), (p - End()).norm());
  if (!Passes(p - centre)) return ends;
  return std::min(ends, std::abs((p - centre).norm() - Radius()));
}

// The least distance is at an end of either, at a crossing, or where the circle is parallel to the
// segment.
double CircleWay::DistanceTo(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  double least =
      std::min({ToSegment(from, a, b), ToSegment(End(), a, b), DistanceTo(a), DistanceTo(b)});
  const double length = (b - a).norm();
  if (length == 0.0) return least;
  const Eigen::Vector2d along = (b - a) / length, normal(-along.y(), along.x());
  for (const double sign : {-1.0, 1.0}) {
    const Eigen::Vector2d out = sign * normal;
    if (Passes(out)) least = std::min(least, ToSegment(centre + Radius() * out, a, b));
  }
  const double beside = (centre - a).dot(normal), middle = (centre - a).dot(along);
  const double squared = Radius() * Radius() - beside * beside;
  if (squared < 0.0) return least;
  for (const double half : {-std::sqrt(squared), std::sqrt(squared)}) {
    const double at = middle + half;
    if (at >= 0.0 && at <= length && Passes(a + at * along - centre)) return 0.0;
  }
  return least;
}

double CircleWay::FarthestFrom(const Eigen::Vector2d& p) const {
  if (Passes(centre - p)) return (p - centre).norm() + Radius();
  return std::max((p - from).norm(), (p - End()).norm());
}

double CircleWay::LeastAlong(const Eigen::Vector2d& direction) const {
  if (Passes(-direction)) return centre.dot(direction) - Radius();
  return std::min(from.dot(direction), End().dot(direction));
}

}  // namespace dockyard
