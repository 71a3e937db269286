// The sensors' readings, converted once per control tick: time, attitude, arm, spool, pose.
#pragma once

#include <cmath>
#include <optional>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/odometry.h"
#include "controller/axel/options.h"
#include "controller/axel/pose_filter.h"
#include "controller/axel/wheel_slip.h"

namespace dockyard::axel {

/// Measures how long a value has stayed within a band.
class StillWatch {
 public:
  explicit StillWatch(double band) : band_(band) {}
  void Reset() { anchor_.reset(); }
  /// How long the value has been still now [ticks].
  Tick Still(Tick now, double value);

 private:
  double band_;
  struct Anchor {
    double value = 0.0;
    Tick since = 0;
  };
  std::optional<Anchor> anchor_;
};

class Senses {
 public:
  Senses(const Nominal& nominal, const AxelOptions& options);

  void Update(const SensorFrame& sensed);

  Tick now() const { return now_; }
  const ImuSample& imu() const { return imu_; }
  const GroundSlope& ground() const { return ground_; }
  /// Takes what a sighting taught about the ground.
  void SetGround(const GroundSlope& ground);
  const Attitude& attitude() const { return attitude_; }  // of the body against the ground
  double yaw_rad() const { return HeadingOf(imu_); }      // of the axle, since power-on
  double pitch_rad() const { return attitude_.pitch_rad; }
  /// Of the arm's tip against the ground's plane through the axle, up positive, in (-180, 180] deg:
  /// beyond 90 deg the arm trails. Body pitch and arm angle both count downwards.
  double elevation_rad() const { return WrapPi(-(attitude_.pitch_rad + arm_rad_)); }
  /// Whether the arm lies behind the axle.
  bool arm_trails() const { return std::abs(elevation_rad()) > 0.5 * kPi; }
  double arm_rad() const { return arm_rad_; }  // against the body, tip-down positive, any turns
  /// Tether taken up since power-on. The drum winds it past the arm's root: an arm that turns
  /// tip-down by an angle gives out as much as a drum that pays out by it.
  double reeled_m() const { return reeled_m_; }
  double rolled_m() const { return rolled_m_; }                // along the heading since power-on
  double spool_current_a() const { return spool_current_a_; }  // low-passed
  /// As WheelThrust, low-passed as the spool's current.
  double wheel_thrust_n() const { return wheel_thrust_n_; }
  /// Sideways way to the left for each metre of way, by the side forces of the last second.
  double side_drift() const { return filter_.slip().Drift(force_); }
  /// Gravity's share of the weight along the axle, to the left, in the last second.
  double side_slope() const { return force_.slope; }
  /// Turning rate that the wheels' slip takes, of the last second.
  double yaw_slip_rad_s() const { return yaw_slip_rad_s_; }
  const PoseFilter& filter() const { return filter_; }
  PoseFilter& filter() { return filter_; }
  Pose2 pose() const { return filter_.pose(); }
  /// By odometry alone, from anywhere: no sighting and no tether moves it.
  Pose2 reckoned() const { return reckoned_; }
  /// By wheels and inertial unit alone, since power-on: as if nothing slipped.
  const Pose2& by_wheels() const { return by_wheels_; }

  /// Board in the body, by dead reckoning; none before the first fix.
  std::optional<Pose3> ExpectedBoard() const;
  /// Corrects the pose by the tether if the tether carries at least this tension and the last
  /// correction is long enough ago.
  void UseTether(double tension_n);

 private:
  GroundForce ForceNow(bool pays_out) const;
  bool WheelsFree(const SensorFrame& sensed) const;

  Nominal nominal_;
  TetherOptions tether_;
  TetherGeometry geometry_;
  double weight_n_;
  Odometer odometer_;
  PoseFilter filter_;
  Pose2 reckoned_;
  Pose2 by_wheels_;
  GroundSlope ground_;
  Attitude attitude_;
  GroundForce force_{};  // low-passed
  double yaw_slip_rad_s_ = 0.0;
  bool started_ = false;
  Tick now_ = 0, last_tether_fix_ = 0;
  ImuSample imu_{};
  double arm_rad_ = 0.0, reeled_m_ = 0.0, rolled_m_ = 0.0, spool_current_a_ = 0.0;
  double wheel_thrust_n_ = 0.0;
};

/// Where the rover was at a time, by its own counting.
struct Moment {
  Tick tick = 0;
  double reeled_m = 0.0, rolled_m = 0.0, yaw_rad = 0.0;
};
inline Moment MomentOf(const Senses& senses) {
  return {senses.now(), senses.reeled_m(), senses.rolled_m(), senses.yaw_rad()};
}

}  // namespace dockyard::axel
