#include "controller/motion/arc_distance.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
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

SweptArc::SweptArc(const Pose2& X_AR, const Arc& arc)
    : p_AR_(X_AR.x, X_AR.y),
      heading_(X_AR.heading),
      turn_(arc.turn_rad),
      length_m_(arc.length_m),
      straight_(std::abs(arc.turn_rad) < kStraight_rad) {
  if (!straight_) centre_R_.y() = arc.length_m / arc.turn_rad;
}

double SweptArc::OfPart(const Eigen::Vector2d& p_RP, const Eigen::Vector2d& p_RE,
                        const Eigen::Vector2d& p_RQ) const {
  if (straight_) {
    return SegmentToSegment(p_RP, p_RE, p_RQ, p_RQ - Eigen::Vector2d(length_m_, 0.0));
  }
  return CircleWay{centre_R_, p_RQ, turn_.Back()}.DistanceTo(p_RP, p_RE);
}

double SweptArc::OfPoint(const Eigen::Vector2d& p_RQ, const Eigen::Vector2d& p_RP,
                         const Eigen::Vector2d& p_RE) const {
  if (straight_) {
    return SegmentToSegment(p_RQ, p_RQ + Eigen::Vector2d(length_m_, 0.0), p_RP, p_RE);
  }
  return CircleWay{centre_R_, p_RQ, turn_}.DistanceTo(p_RP, p_RE);
}

double SweptDistance(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RP,
                     const Eigen::Vector2d& p_RE, const Eigen::Vector2d& p_AQ) {
  const SweptArc swept(X_AR, arc);
  return swept.OfPart(p_RP, p_RE, swept.InR(p_AQ));
}

}  // namespace dockyard
