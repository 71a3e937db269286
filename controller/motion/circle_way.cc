#include "controller/motion/circle_way.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {

double ToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double squared = ab.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * ab).norm();
}

Eigen::Vector2d CircleWay::End() const { return centre + turn * (from - centre); }

// By the sides on which the direction lies of the way's begin and end.
bool CircleWay::Passes(const Eigen::Vector2d& direction) const {
  const double way_rad = std::abs(turn.rad);
  if (way_rad >= 2.0 * kPi) return true;
  const Eigen::Vector2d v = from - centre;
  const double sign = turn.rad < 0.0 ? -1.0 : 1.0;
  const double past_begin = sign * Cross(v, direction);
  const double before_end = v.dot(direction) * sign * turn.sin - past_begin * turn.cos;
  if (way_rad <= kPi) return past_begin >= 0.0 && before_end >= 0.0;
  return past_begin >= 0.0 || before_end >= 0.0;
}

double CircleWay::DistanceTo(const Eigen::Vector2d& p) const {
  const double ends = std::min((p - from).norm(), (p - End()).norm());
  if (!Passes(p - centre)) return ends;
  return std::min(ends, std::abs((p - centre).norm() - Radius()));
}

// The least distance is at an end of either, at a crossing, or where the circle is parallel to the
// segment.
double CircleWay::DistanceTo(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  if (a == b) return DistanceTo(a);
  double least =
      std::min({ToSegment(from, a, b), ToSegment(End(), a, b), DistanceTo(a), DistanceTo(b)});
  const double length = (b - a).norm();
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
