#include "controller/axel/senses.h"

#include <cmath>

#include "controller/axel/drive.h"

namespace dockyard::axel {

Tick StillWatch::Still(Tick now, double value) {
  if (!anchor_ || std::abs(value - anchor_->value) > band_) anchor_ = Anchor{value, now};
  return now - anchor_->since;
}

Senses::Senses(const Nominal& nominal, const AxelOptions& options)
    : nominal_(nominal),
      tether_(options.tether),
      odometer_(nominal),
      filter_(options.noise, TetherGeometryOf(nominal), nominal.X_DB) {}

void Senses::Update(const SensorFrame& sensed) {
  const double seconds = started_ ? kTickSeconds * static_cast<double>(sensed.tick - now_) : 0.0;
  now_ = sensed.tick;
  imu_ = sensed.imu;
  arm_rad_ = ArmAngle(nominal_, sensed);
  reeled_m_ = nominal_.drum_radius_m * (MotorAngle(nominal_, sensed, Motor::kSpool) -
                                        MotorAngle(nominal_, sensed, Motor::kArm));
  const double current = sensed.motors[static_cast<std::size_t>(Motor::kSpool)].current_a;
  const double share = started_ ? 1.0 - std::exp(-seconds / tether_.current_smoothing_s) : 1.0;
  spool_current_a_ += share * (current - spool_current_a_);
  const Motion motion = odometer_.Read(sensed, ground_, filter_.pose().heading);
  rolled_m_ += motion.length_m;
  filter_.Predict(motion, seconds);
  attitude_ = ground_.Against(imu_, filter_.pose().heading);
  started_ = true;
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
