// The ground that rover and station stand on, against gravity. The dock frame D lies on it. Where
// it slopes, the inertial unit's roll and pitch are not those against the ground, on which legs are
// planned and the tether is measured.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

/// Of the body, heading left out: RotZ(heading) RotX(roll) RotY(pitch) is its rotation, heading and
/// roll the axle's (axle_attitude.h). Pitch within (-180, 180] deg: Axel drives upside down too.
struct Attitude {
  double roll_rad = 0.0, pitch_rad = 0.0;
};
Eigen::Matrix3d Tilt(const Attitude& attitude);
/// Against gravity.
Attitude AttitudeOf(const ImuSample& imu);
/// The body's rotation since power-on, and the axle's heading in it.
Eigen::Matrix3d RotationOf(const ImuSample& imu);
double HeadingOf(const ImuSample& imu);

/// One plane under rover and station, learned from sightings: the board's attitude in the body, by
/// vision, and the body's against gravity, by the inertial unit. Level until the sightings say
/// otherwise beyond doubt, so that their noise does not tilt level ground.
class GroundSlope {
 public:
  /// Takes an accepted sighting. sigma_rad: error of the board's attitude, about any axis.
  void Take(const Pose3& X_RB, double sigma_rad, const ImuSample& imu, const Pose3& X_DB);

  bool level() const { return up_D_.z() == 1.0; }
  /// Against gravity, unit.
  const Eigen::Vector3d& up_D() const { return up_D_; }
  /// D's x and y of the normal as estimated, also where that is too little to count as a slope.
  const Eigen::Vector2d& lean_D() const { return lean_D_; }
  /// The body's attitude against the ground, with this heading in D.
  Attitude Against(const ImuSample& imu, double heading_rad) const;

 private:
  // Of up_D's x and y: inverse covariance, and its product with the mean.
  Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d weighted_ = Eigen::Vector2d::Zero();
  Eigen::Vector3d up_D_ = Eigen::Vector3d::UnitZ();
  Eigen::Vector2d lean_D_ = Eigen::Vector2d::Zero();
};

/// Up for the gates of vision, in the body, unit. Before the slope is known, a roll that uneven
/// ground does not give is taken as the slope's: the axle is parallel to the station's ground.
Eigen::Vector3d UpOfStation(const Attitude& attitude, bool slope_known);

}  // namespace dockyard::axel
