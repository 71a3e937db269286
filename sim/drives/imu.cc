#include "sim/drives/imu.h"

namespace dockyard {

void ImuAverage::Start(const LinkMotion& body) {
  last_v_GI_G_ = body.VelocityAt(body.X_GL * p_RI_);
  force_R_.setZero();
  turn_R_.setZero();
  time_s_ = 0.0;
}

void ImuAverage::Add(const LinkMotion& body, double dt_s) {
  const Eigen::Vector3d v_GI_G = body.VelocityAt(body.X_GL * p_RI_);
  const Eigen::Vector3d felt_G = (v_GI_G - last_v_GI_G_) - dt_s * gravity_G_;
  force_R_ += body.X_GL.R.transpose() * felt_G;
  turn_R_ += body.X_GL.R.transpose() * body.w_GL_G * dt_s;
  last_v_GI_G_ = v_GI_G;
  time_s_ += dt_s;
}

ImuSample ImuAverage::Take(const LinkMotion& body, const Pose3& X_WG) {
  const RollPitchYaw attitude = ToRollPitchYaw(X_WG.R * body.X_GL.R);
  ImuSample sample;
  sample.roll_rad = attitude.roll;
  sample.pitch_rad = attitude.pitch;
  sample.yaw_rad = attitude.yaw;
  if (time_s_ > 0.0) {
    sample.rate_R = turn_R_ / time_s_;
    sample.specific_force_R = force_R_ / time_s_;
  } else {
    sample.rate_R = body.X_GL.R.transpose() * body.w_GL_G;
    sample.specific_force_R = -(body.X_GL.R.transpose() * gravity_G_);
  }
  force_R_.setZero();
  turn_R_.setZero();
  time_s_ = 0.0;
  return sample;
}

}  // namespace dockyard
