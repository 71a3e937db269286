// Follows a path of arcs: from the robot's pose to the speed and the turning rate to drive.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "controller/motion/arcs.h"

namespace dockyard {

/// Speed of the axle's middle and turning rate.
struct Twist {
  double speed_m_s = 0.0;
  double turn_rad_s = 0.0;
};

/// How hard to steer back to the path.
struct Steering {
  double settle_m = 0.5;         // distance over which an offset dies out (critically damped)
  double max_turn_rad_s = 0.12;  // bounds the wheels' difference
};

/// Follows a path of arcs in D from any pose of the rover: progress by projection onto the path,
/// steering by offset and heading error. The same law forwards and backwards:
///   turn = v k - 2|v|/s (e_heading + d sign v) - v/s^2 e_left,   s = settle_m.
/// A rover that drifts sideways by d of its way keeps to the path at a heading beside it.
class PathFollower {
 public:
  PathFollower(const Pose2& X_DR_start, std::vector<Arc> arcs);

  /// Moves the progress to X_DR and returns the twist at this speed (>= 0; the arc gives the sign).
  /// Zero when done.
  /// drift: sideways way to the rover's left for each metre driven.
  Twist Follow(const Pose2& X_DR, double speed_m_s, const Steering& steering, double drift = 0.0);
  bool done() const { return current_ >= arcs_.size(); }
  double Remaining() const;  // distance left [m]
  bool forward() const { return !done() && arcs_[current_].length_m >= 0.0; }
  /// Projection of the rover onto the path.
  Pose2 Reference() const;

 private:
  std::vector<Arc> arcs_;
  std::vector<Pose2> starts_;
  std::size_t current_ = 0;
  double progress_m_ = 0.0;  // along arcs_[current_], >= 0
};

}  // namespace dockyard
