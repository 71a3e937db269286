#include "toy_underwater/swim_in.h"

#include <algorithm>
#include <cmath>

#include "toy_underwater/diver_body.h"

namespace dockyard::diver {
namespace {

// In the order of the system's sensors.
enum Reading { kDepth, kForward, kLeft, kUp, kRange, kBearing, kElevation };

class SwimIn final : public Controller {
 public:
  explicit SwimIn(const Json& nominal)
      : end_m_(nominal.at("length_m").get<double>() + nominal.at("nose_m").get<double>()) {}

  Commands Step(const SensorFrame& sensed) override {
    const std::vector<double>& values = sensed.values;
    const Eigen::Vector3d v_R(values[kForward], values[kLeft], values[kUp]);
    const RollPitchYaw angles{sensed.imu.roll_rad, sensed.imu.pitch_rad, sensed.imu.yaw_rad};
    const Eigen::Matrix3d R_DR = ToRotation(angles);
    Locate(values, R_DR, v_R);
    belief_.X_DR = RobotPose(Pose3{R_DR, p_D_});
    belief_.values = {{"believed_up_m", p_D_.z()}};

    Commands commands;
    const bool still = std::abs(v_R.x()) < 0.04;  // four times the noise
    still_ = belief_.phase == "in" && p_D_.x() < 0.0 && still ? still_ + kPeriod : 0;
    if (still_ > 3000) commands.verdict = Verdict::kDone;  // pressed against the end
    Push(R_DR.transpose() * WantedSpeed(), v_R, angles.yaw, sensed.imu.rate_R.z(), commands);
    return commands;
  }
  const Belief& belief() const override { return belief_; }

 private:
  /// A fix is of where it was a quarter of a second ago: at these speeds 5 cm.
  void Locate(const std::vector<double>& values, const Eigen::Matrix3d& R_DR,
              const Eigen::Vector3d& v_R) {
    const Eigen::Vector3d fix(values[kRange], values[kBearing], values[kElevation]);
    const Eigen::Vector3d p_RD =
        fix.x() * Eigen::Vector3d(std::cos(fix.z()) * std::cos(fix.y()),
                                  std::cos(fix.z()) * std::sin(fix.y()), std::sin(fix.z()));
    const Eigen::Vector3d p_D = -(R_DR * p_RD);
    if (!belief_.located) p_D_ = p_D;
    p_D_ += 1e-3 * kPeriod * (R_DR * v_R);
    if (fix != fix_) p_D_ += 0.2 * (p_D - p_D_);
    p_D_.z() = kCageDepth_m - values[kDepth];
    fix_ = fix;
    belief_.located = true;
  }

  /// In D: first to a point 2.5 m before the mouth, then along the axis.
  Eigen::Vector3d WantedSpeed() {
    const double off_m = p_D_.tail<2>().norm();
    if (belief_.phase.empty()) belief_.phase = "to_axis";
    if (belief_.phase == "to_axis" && off_m < 0.15 && p_D_.x() > 1.0) belief_.phase = "in";
    if (belief_.phase == "in" && off_m > 0.5) belief_.phase = "to_axis";
    const bool in = belief_.phase == "in";
    const Eigen::Vector3d to = Eigen::Vector3d(in ? -end_m_ - 0.5 : 2.5, 0.0, 0.0) - p_D_;
    return (0.5 * to).cwiseMax(in ? -0.2 : -0.4).cwiseMin(0.4);
  }

  static void Push(const Eigen::Vector3d& wanted_R, const Eigen::Vector3d& v_R, double yaw_rad,
                   double yaw_rad_s, Commands& commands) {
    const Eigen::Vector3d force_n = 40.0 * (wanted_R - v_R);
    const double moment_nm = -2.0 * WrapPi(yaw_rad - kPi) - 2.0 * yaw_rad_s;
    const double turn_n = 0.5 * moment_nm / kThrusterArm_m;
    for (const double thrust_n :
         {0.5 * force_n.x() - turn_n, 0.5 * force_n.x() + turn_n, force_n.y(), force_n.z()}) {
      const double speed_rad_s = std::sqrt(std::abs(thrust_n) / kThrust_n_s2);
      commands.motors.push_back(
          {.mode = MotorMode::kVelocity,
           .target = std::copysign(std::min(speed_rad_s, kMostSpeed_rad_s), thrust_n)});
    }
  }

  double end_m_;
  Belief belief_;
  Eigen::Vector3d p_D_{0, 0, 0}, fix_{0, 0, 0};
  Tick still_ = 0;
};

}  // namespace

std::unique_ptr<Controller> MakeSwimIn(const Json& nominal) {
  return std::make_unique<SwimIn>(nominal);
}

}  // namespace dockyard::diver
