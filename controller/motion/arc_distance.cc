#include "controller/motion/arc_distance.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/circle_way.h"

namespace dockyard {
namespace {

double SegmentToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                        const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  const double c_side = Cross(b - a, c - a), d_side = Cross(b - a, d - a);
  const double a_side = Cross(d - c, a - c), b_side = Cross(d - c, b - c);
  if (c_side * d_side < 0.0 && a_side * b_side < 0.0) return 0.0;
  return std::min({ToSegment(a, c, d), ToSegment(b, c, d), ToSegment(c, a, b), ToSegment(d, a, b)});
}

}  // namespace

double SweptDistance(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RP,
                     const Eigen::Vector2d& p_RE, const Eigen::Vector2d& p_AQ) {
  const Eigen::Vector2d p_RQ = Inverse(X_AR) * p_AQ;
  if (std::abs(arc.turn_rad) < kStraight_rad) {
    return SegmentToSegment(p_RP, p_RE, p_RQ, p_RQ - Eigen::Vector2d(arc.length_m, 0.0));
  }
  const Eigen::Vector2d centre(0.0, arc.length_m / arc.turn_rad);
  return CircleWay{centre, p_RQ, -arc.turn_rad}.DistanceTo(p_RP, p_RE);
}

double SweptDistanceOfPoint(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RQ,
                            const Eigen::Vector2d& p_AP, const Eigen::Vector2d& p_AE) {
  const Pose2 X_RA = Inverse(X_AR);
  const Eigen::Vector2d p_RP = X_RA * p_AP, p_RE = X_RA * p_AE;
  if (std::abs(arc.turn_rad) < kStraight_rad) {
    return SegmentToSegment(p_RQ, p_RQ + Eigen::Vector2d(arc.length_m, 0.0), p_RP, p_RE);
  }
  const Eigen::Vector2d centre(0.0, arc.length_m / arc.turn_rad);
  return CircleWay{centre, p_RQ, arc.turn_rad}.DistanceTo(p_RP, p_RE);
}

}  // namespace dockyard
