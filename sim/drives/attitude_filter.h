// Attitude from the readings of gyros and accelerometers. W is level and z up, its x axis where the
// body's was at power-on.
#pragma once

#include <Eigen/Geometry>

#include "models/parts/imu.h"

namespace dockyard {

struct Attitude {
  Eigen::Quaterniond q_WR = Eigen::Quaterniond::Identity();
  Eigen::Vector3d bias_R{0, 0, 0};  // of the gyros, as Mahony's filter learns it [rad/s]
};

/// Level by this specific force, with a yaw of 0.
Attitude LevelledBy(const Eigen::Vector3d& force_R);

/// Takes in one reading over dt_s by the unit's filter.
void TakeIn(const AttitudeUnit& unit, const Eigen::Vector3d& rate_R, const Eigen::Vector3d& force_R,
            double dt_s, Attitude& attitude);

}  // namespace dockyard
