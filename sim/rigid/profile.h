// The path of a drive to its target, which its servo follows: trapezoid of speed or smooth spline.
#pragma once

#include <array>

#include "controller/io/commands.h"
#include "models/parts/motor.h"

namespace dockyard {

/// Where the profile wants the shaft to be.
struct ProfileState {
  double angle_rad = 0.0;
  double speed_rad_s = 0.0;
  double accel_rad_s2 = 0.0;  // splines only
};

/// One step of a trapezoidal move towards the command's target. Speed never steps by more than the
/// slope allows, so a changed command goes on from the present speed.
ProfileState AdvanceProfile(const ProfileState& at, const MotorCommand& command,
                            const MotorModel& motor, double dt_s);

/// A move without a jump in speed or acceleration: in position a polynomial of fifth degree that
/// ends at rest on the target, in speed one of third degree (Biagiotti and Melchiorri, Trajectory
/// Planning, 2008, section 2.1). From rest to rest its peak speed is 15/8 D / T and its peak
/// acceleration 10 / sqrt(3) D / T^2.
class SplineMove {
 public:
  /// Shortest of the moves from there, to 5 %, that stay within the command's and motor's limits
  /// where the start does.
  SplineMove(const ProfileState& from, const MotorCommand& command, const MotorModel& motor);
  SplineMove() = default;

  ProfileState At(double time_s) const;
  double duration_s() const { return duration_s_; }

 private:
  void Fit(const ProfileState& from, const MotorCommand& command, double target);
  bool Keeps(double speed_rad_s, double accel_rad_s2) const;

  std::array<double, 6> c_{};  // of the angle, by power of time
  double duration_s_ = 0.0;
};

}  // namespace dockyard
