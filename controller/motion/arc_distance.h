// How near parts of a rover come to fixed things while the rover drives an arc. Exact.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/pose.h"
#include "controller/motion/arcs.h"
#include "controller/motion/circle_way.h"

namespace dockyard {

/// An arc from X_AR, for many distances.
class SweptArc {
 public:
  SweptArc(const Pose2& X_AR, const Arc& arc);

  /// Into R as the arc begins.
  Eigen::Vector2d InR(const Eigen::Vector2d& p_AQ) const {
    return heading_.Back() * (p_AQ - p_AR_);
  }
  /// As SweptDistance() below; the point in R as the arc begins.
  double OfPart(const Eigen::Vector2d& p_RP, const Eigen::Vector2d& p_RE,
                const Eigen::Vector2d& p_RQ) const;
  /// Of the rover's point p_RQ from a fixed segment, in R as the arc begins.
  double OfPoint(const Eigen::Vector2d& p_RQ, const Eigen::Vector2d& p_RP,
                 const Eigen::Vector2d& p_RE) const;

 private:
  Eigen::Vector2d p_AR_, centre_R_{0, 0};
  Turn heading_, turn_;
  double length_m_ = 0.0;
  bool straight_ = false;
};

/// Least distance [m] of the point p_AQ from a straight part of the rover, from p_RP to p_RE, while
/// the rover drives the arc from X_AR; 0 where the part passes over the point. Equal ends: a point
/// of the rover. Closed form: seen from the rover the point moves along a circle or a line.
double SweptDistance(const Pose2& X_AR, const Arc& arc, const Eigen::Vector2d& p_RP,
                     const Eigen::Vector2d& p_RE, const Eigen::Vector2d& p_AQ);

}  // namespace dockyard
