// The ground that the rover drives on, by the body's attitude.
#pragma once

#include <Eigen/Core>

#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

/// Roll and pitch against the ground: those of the inertial unit on level ground; none where the
/// ground, near and ahead, is taken to be parallel to the body.
inline ImuSample AgainstGround(ImuSample attitude, bool ground_as_body) {
  if (ground_as_body) attitude.roll_rad = attitude.pitch_rad = 0.0;
  return attitude;
}

/// A plane for the ground: the mean of the body's attitude over the last metre or so, in which
/// stones under the wheels cancel out. Angles add up as for small ones: 10 deg err by 0.2.
class GroundPlane {
 public:
  /// Of a rover that has driven so far since the last call; the first call takes the attitude.
  void Add(const ImuSample& attitude, double driven_m);
  /// Roll and pitch that a body parallel to the ground has, heading as in `now`.
  ImuSample Parallel(const ImuSample& now) const;
  /// The ground's rise along x and y of a level frame, x ahead as in `now`.
  Eigen::Vector2d Rise(const ImuSample& now) const;

 private:
  // Roll and pitch as a vector of two axes that do not turn with the body.
  Eigen::Vector2d mean_W_{0, 0};
  bool begun_ = false;
};

}  // namespace dockyard::rocky7
