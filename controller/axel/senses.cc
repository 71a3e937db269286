#include "controller/axel/senses.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/drive.h"

namespace dockyard::axel {
namespace {

// Paddles roll and pitch the rover by the step, a third of a metre: the drift to steer against is
// its mean. Assumed, 0.5-3 s.
constexpr double kForceSeconds = 1.0;

}  // namespace

Tick StillWatch::Still(Tick now, double value) {
  if (!anchor_ || std::abs(value - anchor_->value) > band_) anchor_ = Anchor{value, now};
  return now - anchor_->since;
}

Senses::Senses(const Nominal& nominal, const AxelOptions& options)
    : nominal_(nominal),
      tether_(options.tether),
      geometry_(TetherGeometryOf(nominal)),
      weight_n_(options.noise.weight_n),
      odometer_(nominal),
      filter_(options.noise, geometry_, nominal.X_DB) {}

void Senses::Update(const SensorFrame& sensed) {
  const double seconds = started_ ? kTickSeconds * static_cast<double>(sensed.tick - now_) : 0.0;
  now_ = sensed.tick;
  imu_ = sensed.imu;
  arm_rad_ = ArmAngle(nominal_, sensed);
  const double reeled_before_m = reeled_m_;
  reeled_m_ = nominal_.drum_radius_m * (MotorAngle(nominal_, sensed, Motor::kSpool) -
                                        MotorAngle(nominal_, sensed, Motor::kArm));
  const double current = sensed.motors[static_cast<std::size_t>(Motor::kSpool)].current_a;
  const double share = started_ ? 1.0 - std::exp(-seconds / tether_.current_smoothing_s) : 1.0;
  spool_current_a_ += share * (current - spool_current_a_);
  wheel_thrust_n_ += share * (WheelThrust(nominal_, sensed) - wheel_thrust_n_);
  const Motion motion = odometer_.Read(sensed, ground_, filter_.pose().heading);
  rolled_m_ += motion.length_m;
  by_wheels_ = Advance(by_wheels_, Arc{motion.length_m, motion.turn_rad});
  const GroundForce force = ForceNow(reeled_m_ < reeled_before_m);
  const Pose2 before = filter_.pose();
  filter_.Predict(motion, seconds, force, WheelsFree(sensed));
  reckoned_ = reckoned_ * (Inverse(before) * filter_.pose());
  const double force_share = started_ ? 1.0 - std::exp(-seconds / kForceSeconds) : 1.0;
  force_.slope += force_share * (force.slope - force_.slope);
  force_.tether += force_share * (force.tether - force_.tether);
  if (seconds > 0.0) {
    const double yaw_slip = (motion.wheel_turn_rad - motion.turn_rad) / seconds;
    yaw_slip_rad_s_ += force_share * (yaw_slip - yaw_slip_rad_s_);
  }
  attitude_ = ground_.Against(imu_, filter_.pose().heading);
  started_ = true;
}

// The gears take their friction from the motor's pull, or add it while the tether is dragged out.
GroundForce Senses::ForceNow(bool pays_out) const {
  const double friction_n = pays_out ? nominal_.spool_friction_n : -nominal_.spool_friction_n;
  const double tension_n = TensionFromCurrent(nominal_, spool_current_a_);
  const double tether_n = tension_n > 0.0 ? std::max(0.0, tension_n + friction_n) : 0.0;
  return GroundForceOn(imu_, ground_, geometry_, filter_.pose(), tether_n, weight_n_);
}

// A wheel that is driven draws at least what its gears take. Half of it tells the two apart;
// assumed, 0.3-0.7.
bool Senses::WheelsFree(const SensorFrame& sensed) const {
  for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
    const auto i = static_cast<std::size_t>(wheel);
    if (std::abs(sensed.motors[i].current_a) > 0.5 * nominal_.motors[i].no_load_current_a)
      return false;
  }
  return true;
}

void Senses::SetGround(const GroundSlope& ground) {
  ground_ = ground;
  attitude_ = ground_.Against(imu_, filter_.pose().heading);
}

std::optional<Pose3> Senses::ExpectedBoard() const {
  if (!filter_.located()) return std::nullopt;
  const Pose3 X_DH = FromGround(filter_.pose(), nominal_.wheel_radius_m);
  const Pose3 X_HR{Tilt(attitude_), Eigen::Vector3d::Zero()};
  return Inverse(X_DH * X_HR) * nominal_.X_DB;
}

void Senses::UseTether(double tension_n) {
  if (now_ - last_tether_fix_ < tether_.tether_fix_period) return;
  if (TensionFromCurrent(nominal_, spool_current_a_) < tension_n) return;
  filter_.CorrectByTether(reeled_m_, elevation_rad());
  last_tether_fix_ = now_;
}

}  // namespace dockyard::axel
