#include "sim/drives/attitude_filter.h"

#include <cmath>

namespace dockyard {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

void Turn(const Vector3d& turn_R, Quaterniond& q_WR) {
  const double angle_rad = turn_R.norm();
  if (angle_rad == 0.0) return;
  q_WR = (q_WR * Quaterniond(Eigen::AngleAxisd(angle_rad, turn_R / angle_rad))).normalized();
}

/// The descent's direction in the quaternion: the gradient of |up by q - up_R|^2 / 2, of length 1,
/// or 0 where there is none.
Eigen::Vector4d Gradient(const Quaterniond& q, const Vector3d& up_R) {
  const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
  const Vector3d miss =
      Vector3d(2.0 * (x * z - w * y), 2.0 * (w * x + y * z), 2.0 * (0.5 - x * x - y * y)) - up_R;
  Eigen::Matrix<double, 3, 4> J;
  J << -2.0 * y, 2.0 * z, -2.0 * w, 2.0 * x, 2.0 * x, 2.0 * w, 2.0 * z, 2.0 * y, 0.0, -4.0 * x,
      -4.0 * y, 0.0;
  const Eigen::Vector4d gradient = J.transpose() * miss;
  return gradient.norm() > 0.0 ? Eigen::Vector4d(gradient.normalized()) : gradient;
}

}  // namespace

Attitude LevelledBy(const Vector3d& force_R) {
  const double roll = std::atan2(force_R.y(), force_R.z());
  const double pitch = std::atan2(-force_R.x(), std::hypot(force_R.y(), force_R.z()));
  return {Quaterniond(Eigen::AngleAxisd(pitch, Vector3d::UnitY()) *
                      Eigen::AngleAxisd(roll, Vector3d::UnitX()))};
}

void TakeIn(const AttitudeUnit& unit, const Vector3d& rate_R, const Vector3d& force_R, double dt_s,
            Attitude& attitude) {
  const double force = force_R.norm();
  const Vector3d up_R = force > 0.0 ? Vector3d(force_R / force) : Vector3d::Zero();
  Turn(dt_s * (rate_R - attitude.bias_R), attitude.q_WR);
  if (unit.filter == AttitudeFilter::kMahony) {
    const Vector3d miss_R = up_R.cross(attitude.q_WR.conjugate() * Vector3d::UnitZ());
    attitude.bias_R -= unit.ki_per_s2 * dt_s * miss_R;
    Turn(unit.kp_per_s * dt_s * miss_R, attitude.q_WR);
    return;
  }
  if (force == 0.0) return;
  const Eigen::Vector4d step = unit.beta_per_s * dt_s * Gradient(attitude.q_WR, up_R);
  const Quaterniond& q = attitude.q_WR;
  attitude.q_WR =
      Quaterniond(q.w() - step[0], q.x() - step[1], q.y() - step[2], q.z() - step[3]).normalized();
}

}  // namespace dockyard
