#include "sim/axel/exposure.h"

#include <algorithm>

#include "models/axel/station_model.h"
#include "render/shutter.h"

namespace dockyard::axel {
namespace {

Pose3 TurnedAboutY(const Pose3& X, double angle_rad) { return {X.R * RotY(angle_rad), X.p}; }

}  // namespace

Truth MovedOn(const Truth& truth, double seconds) {
  Truth moved = truth;
  moved.X_WR = MovedOn(truth.X_WR, truth.v_WR_W, truth.w_WR_W, seconds);
  const Pose3 moving = moved.X_WR * Inverse(truth.X_WR);
  moved.X_WA = TurnedAboutY(moving * truth.X_WA, seconds * truth.arm_rate_rad_s);
  const auto wheel = [&](const Pose3& X_WK, Motor motor) {
    const double rate = truth.motor_speed_rad_s[static_cast<std::size_t>(motor)];
    return TurnedAboutY(moving * X_WK, seconds * rate);
  };
  moved.X_W_left_wheel = wheel(truth.X_W_left_wheel, Motor::kLeftWheel);
  moved.X_W_right_wheel = wheel(truth.X_W_right_wheel, Motor::kRightWheel);
  for (MovingLink& link : moved.further) {
    link.X_WL = MovedOn(link.X_WL, link.v_WL_W, link.w_WL_W, seconds);
  }
  return moved;
}

double BoardMotion_px(const Truth& truth, const BuiltRun& built, double seconds) {
  const StereoRig& rig = built.built_rig;
  const Eigen::Vector3d p_W_board = (truth.X_WS * BoardInStation(built.world.station)).p;
  double most_px = 0.0;
  for (const Pose3& X_RC : {rig.X_RL, rig.X_RQ}) {
    const Eigen::Vector3d arm_W = truth.X_WR.R * X_RC.p;
    const Eigen::Vector3d v_W = truth.v_WR_W + truth.w_WR_W.cross(arm_W);
    const double distance_m = std::max(0.3, (p_W_board - truth.X_WR.p - arm_W).norm());
    most_px = std::max(most_px, MotionInExposure_px(rig.left, truth.w_WR_W.norm(), v_W.norm(),
                                                    distance_m, seconds));
  }
  return most_px;
}

}  // namespace dockyard::axel
