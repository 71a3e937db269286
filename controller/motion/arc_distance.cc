#include "controller/motion/arc_distance.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr double kStraight_rad = 1e-9;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double ToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double squared = ab.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - share * ab).norm();
}

double SegmentToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                        const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  const double c_side = Cross(b - a, c - a), d_side = Cross(b - a, d - a);
  const double a_side = Cross(d - c, a - c), b_side = Cross(d - c, b - c);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return 0.0;
  return std::min({ToSegment(a, c, d), ToSegment(b, c, d), ToSegment(c, a, b), ToSegment(d, a, b)});
}

/// The way of a point round a centre, by an angle from where it is.
struct CircleWay {
  Eigen::Vector2d centre, from;
  double turn_rad = 0.0;

  double radius() const { return (from - centre).norm(); }
  Eigen::Vector2d End() const {
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    const Eigen::Vector2d v = from - centre;
    return centre + Eigen::Vector2d(c * v.x() - s * v.y(), s * v.x() + c * v.y());
  }
  bool Passes(const Eigen::Vector2d& direction) const {
    if (std::abs(turn_rad) >= 2.0 * kPi) return true;
    const Eigen::Vector2d v = from - centre;
    double angle = std::atan2(Cross(v, direction), v.dot(direction));
    if (turn_rad < 0.0) angle = -angle;
    if (angle < 0.0) angle += 2.0 * kPi;
    return angle <= std::abs(turn_rad);
  }
  double DistanceTo(const Eigen::Vector2d& p) const {
    const double ends = std::min((p - from).norm(), (p - End()).norm());
    if (!Passes(p - centre)) return ends;
    return std::min(ends, std::abs((p - centre).norm() - radius()));
  }
};

// The least distance is at an end of either, at a crossing, or where the circle is parallel to the
// segment.
double CircleToSegment(const CircleWay& way, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  double least = std::min({ToSegment(way.from, a, b), ToSegment(way.End(), a, b), way.DistanceTo(a),
                           way.DistanceTo(b)});
  const double length = (b - a).norm();
  if (length == 0.0) return least;
  const Eigen::Vector2d along = (b - a) / length, normal(-along.y(), along.x());
  for (const double sign : {-1.0, 1.0}) {
    const Eigen::Vector2d out = sign * normal;
    if (way.Passes(out)) least = std::min(least, ToSegment(way.centre + way.radius() * out, a, b));
  }
  const double beside = (way.centre - a).dot(normal), middle = (way.centre - a).dot(along);
  const double squared = way.radius() * way.radius() - beside * beside;
  if (squared < 0.0) return least;
  for (const double half : {-std::sqrt(squared), std::sqrt(squared)}) {
    const double at = middle + half;
    if (at >= 0.0 && at <= length && way.Passes(a + at * along - way.centre)) return 0.0;
  }
  return least;
}

}  // namespace

double SweptDistance(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RP,
                     const Eigen::Vector2d& p_RE, const Eigen::Vector2d& p_AQ) {
  const Eigen::Vector2d p_RQ = Inverse(X_AR) * p_AQ;
  if (std::abs(arc.turn_rad) < kStraight_rad) {
    return SegmentToSegment(p_RP, p_RE, p_RQ, p_RQ - Eigen::Vector2d(arc.length_m, 0.0));
  }
  const Eigen::Vector2d centre(0.0, arc.length_m / arc.turn_rad);
  return CircleToSegment({centre, p_RQ, -arc.turn_rad}, p_RP, p_RE);
}

}  // namespace dockyard
