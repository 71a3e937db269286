// From a wanted twist to one that the robot can follow.
#pragma once

#include "controller/custom/nominal/docking.h"
#include "controller/motion/path_follower.h"

namespace dockyard::custom {

class TwistLimits {
 public:
  explicit TwistLimits(const DockingOptions& options) : options_(options) {}

  /// The twist for the next control period. It changes no faster than the accelerations allow. A
  /// speed within the dead band becomes the dead band, not zero: a robot that still has to move
  /// would never arrive at zero. The same holds for the rate of a turn in place. Zero stays zero.
  Twist Step(const Twist& wanted, double dt_s);
  const Twist& twist() const { return twist_; }

 private:
  DockingOptions options_;
  Twist ramp_, twist_;
};

/// The fastest speed from which the robot can brake to end_m_s over a distance.
double BrakingSpeed(double left_m, double end_m_s, double accel_m_s2);

/// A turn in place by what is left, which slows down in time to stop there.
Twist TurnBy(double left_rad, const DockingOptions& options);

}  // namespace dockyard::custom
