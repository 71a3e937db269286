#include "sim/drives/imu.h"

namespace dockyard {

void ImuAverage::Sum::Add(const Eigen::Vector3d& step_turn_R, const Eigen::Vector3d& step_push_R,
                          double dt_s) {
  turn_R += step_turn_R;
  push_R += step_push_R;
  time_s += dt_s;
}

void ImuAverage::Start(const LinkMotion& body) {
  last_v_GI_G_ = body.VelocityAt(body.X_GL * p_RI_);
  sum_ = reading_ = {};
  readings_.clear();
  due_s_ = period_s_;
}

void ImuAverage::Add(const LinkMotion& body, double dt_s) {
  const Eigen::Vector3d v_GI_G = body.VelocityAt(body.X_GL * p_RI_);
  const Eigen::Vector3d felt_G = (v_GI_G - last_v_GI_G_) - dt_s * gravity_G_;
  const Eigen::Vector3d push_R = body.X_GL.R.transpose() * felt_G;
  const Eigen::Vector3d turn_R = body.X_GL.R.transpose() * body.w_GL_G * dt_s;
  last_v_GI_G_ = v_GI_G;
  sum_.Add(turn_R, push_R, dt_s);
  if (period_s_ <= 0.0) return;
  reading_.Add(turn_R, push_R, dt_s);
  due_s_ -= dt_s;
  if (due_s_ > 1e-9) return;
  readings_.push_back(reading_.Mean());
  reading_ = {};
  due_s_ += period_s_;
}

TrueImu ImuAverage::Take(const LinkMotion& body, const Pose3& X_WG) {
  const RollPitchYaw attitude = ToRollPitchYaw(X_WG.R * body.X_GL.R);
  ImuSample sample;
  sample.roll_rad = attitude.roll;
  sample.pitch_rad = attitude.pitch;
  sample.yaw_rad = attitude.yaw;
  if (sum_.time_s > 0.0) {
    const InertialMean mean = sum_.Mean();
    sample.rate_R = mean.rate_R;
    sample.specific_force_R = mean.specific_force_R;
  } else {
    sample.rate_R = body.X_GL.R.transpose() * body.w_GL_G;
    sample.specific_force_R = -(body.X_GL.R.transpose() * gravity_G_);
  }
  sum_ = {};
  return {sample, std::exchange(readings_, {})};
}

}  // namespace dockyard
