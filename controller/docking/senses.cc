#include "controller/docking/senses.h"

#include <cmath>

#include "controller/motion/drive.h"

namespace dockyard {

Tick StillWatch::Still(Tick now, double value) {
  if (!anchor_ || std::abs(value - anchor_->value) > band_) anchor_ = Anchor{value, now};
  return now - anchor_->since;
}

Senses::Senses(const RoverSheet& sheet, const AxelOptions& options)
    : sheet_(sheet),
      tether_(options.tether),
      odometer_(sheet),
      filter_(options.noise, TetherGeometryOf(sheet), sheet.X_DB) {}

void Senses::Update(const SensorFrame& sensed) {
  const double seconds = started_ ? kTickSeconds * static_cast<double>(sensed.tick - now_) : 0.0;
  now_ = sensed.tick;
  imu_ = sensed.imu;
  elevation_rad_ = ArmElevation(sheet_, sensed);
  arm_rad_ = ArmAngle(sheet_, sensed);
  reeled_m_ = sheet_.drum_radius_m * MotorAngle(sheet_, sensed, Motor::kSpool);
  const double current = sensed.current_a[static_cast<std::size_t>(Motor::kSpool)];
  const double share = started_ ? 1.0 - std::exp(-seconds / tether_.current_smoothing_s) : 1.0;
  spool_current_a_ += share * (current - spool_current_a_);
  filter_.Predict(odometer_.Read(sensed), seconds);
  started_ = true;
}

std::optional<Pose3> Senses::ExpectedBoard() const {
  if (!filter_.located()) return std::nullopt;
  const Pose3 X_DH = FromGround(filter_.pose(), sheet_.wheel_radius_m);
  const Pose3 X_HR{Tilt(imu_), Eigen::Vector3d::Zero()};
  return Inverse(X_DH * X_HR) * sheet_.X_DB;
}

void Senses::UseTether(double tension_n) {
  if (now_ - last_tether_fix_ < tether_.tether_fix_period) return;
  if (TensionFromCurrent(sheet_, spool_current_a_) < tension_n) return;
  filter_.CorrectByTether(reeled_m_, elevation_rad_);
  last_tether_fix_ = now_;
}

}  // namespace dockyard
