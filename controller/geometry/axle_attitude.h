// Attitude of a body on one axle of two wheels, which may turn about the axle by any angle: heading
// and roll are the axle's, pitch is the body's turn about it. Unlike roll, pitch and yaw about
// moving axes (pose.h) it knows no singular pitch: it fails only with the axle on end.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard {

/// R = RotZ(heading) RotX(roll) RotY(pitch) [rad]. Heading is where a level body's x axis points:
/// it does not change as the body turns over. Roll is within +-90 deg, left side up positive; pitch
/// within (-180, 180] deg, nose-down positive, 180 deg: upside down.
struct AxleAttitude {
  double roll = 0.0, pitch = 0.0, heading = 0.0;
};

/// Of a body whose y axis is the axle, to the left. An axle on end has heading 0.
AxleAttitude ToAxleAttitude(const Eigen::Matrix3d& R);
Eigen::Matrix3d ToRotation(const AxleAttitude& attitude);

/// Place on the ground plane with the axle's heading. Of an upright body as ToGround.
Pose2 AxleOnGround(const Pose3& X_AB);

}  // namespace dockyard
