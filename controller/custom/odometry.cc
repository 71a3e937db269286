#include "controller/custom/odometry.h"

#include <cmath>

#include "controller/base/check.h"
#include "controller/motion/arcs.h"

namespace dockyard::custom {
namespace {

// The share is learned from stretches of a turn, as counts of encoders are too coarse for single
// periods. Assumed, 0.05-0.2 rad.
constexpr double kStretch_rad = 0.1;
// Weight of the first belief about the share: that of three stretches. Assumed, 1-10.
constexpr double kBelief_rad2 = 3.0 * kStretch_rad * kStretch_rad;

}  // namespace

Odometry::Odometry(const Nominal& nominal, const Drive& drive)
    : drive_(drive),
      has_imu_(nominal.has_imu),
      by_both_(drive.turn_share * kBelief_rad2),
      by_wheels_(kBelief_rad2) {
  for (const JointDrive& motor : nominal.motors)
    rad_per_count_.push_back(motor.motor.rad_per_count);
}

void Odometry::Learn(double wheels_rad, double unit_rad) {
  wheels_rad_ += wheels_rad;
  unit_rad_ += unit_rad;
  if (std::abs(wheels_rad_) < kStretch_rad) return;
  by_both_ += wheels_rad_ * unit_rad_;
  by_wheels_ += wheels_rad_ * wheels_rad_;
  wheels_rad_ = unit_rad_ = 0.0;
}

Motion Odometry::Read(const SensorFrame& sensed) {
  DOCKYARD_CHECK(sensed.motors.size() == rad_per_count_.size());
  Last now{{}, sensed.imu.yaw_rad};
  for (const MotorReading& motor : sensed.motors) now.counts.push_back(motor.encoder_counts);
  Motion motion;
  if (last_) {
    double sides_m = 0.0;  // right less left
    const double per_side = 0.5 * static_cast<double>(drive_.wheels.size());
    for (const DrivenWheel& wheel : drive_.wheels) {
      const auto i = static_cast<std::size_t>(wheel.motor);
      const double turned = static_cast<double>(now.counts[i] - last_->counts[i]);
      const double rolled_m = turned * rad_per_count_[i] * wheel.travel_m_per_rad / per_side;
      motion.length_m += 0.5 * rolled_m;
      sides_m -= wheel.side * rolled_m;
    }
    const double by_wheels = sides_m / drive_.gauge_m;
    if (has_imu_) {
      motion.turn_rad = WrapPi(now.yaw_rad - last_->yaw_rad);
      Learn(by_wheels, motion.turn_rad);
    } else {
      motion.turn_rad = drive_.turn_share * by_wheels;
    }
    X_OA_ = Advance(X_OA_, Arc{motion.length_m, motion.turn_rad});
  }
  last_ = std::move(now);
  return motion;
}

}  // namespace dockyard::custom
