#include "controller/geometry/axle_attitude.h"

#include <algorithm>
#include <cmath>

namespace dockyard {

AxleAttitude ToAxleAttitude(const Eigen::Matrix3d& R) {
  AxleAttitude attitude;
  attitude.roll = std::asin(std::clamp(R(2, 1), -1.0, 1.0));
  attitude.heading = std::atan2(-R(0, 1), R(1, 1));
  const Eigen::Matrix3d turn = RotX(-attitude.roll) * RotZ(-attitude.heading) * R;
  attitude.pitch = std::atan2(turn(0, 2), turn(0, 0));
  return attitude;
}

Eigen::Matrix3d ToRotation(const AxleAttitude& attitude) {
  return RotZ(attitude.heading) * RotX(attitude.roll) * RotY(attitude.pitch);
}

Pose2 AxleOnGround(const Pose3& X_AB) {
  return {X_AB.p.x(), X_AB.p.y(), std::atan2(-X_AB.R(0, 1), X_AB.R(1, 1))};
}

}  // namespace dockyard
