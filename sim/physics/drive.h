// A motor's drive at the output shaft: trapezoidal profile, servo within the current limit, gear
// friction in every mode, brake.
#pragma once

#include <cstdint>

#include "controller/io/commands.h"
#include "models/rover_model.h"
#include "sim/physics/bristle.h"

namespace dockyard {

/// Where the profile wants the shaft to be.
struct ProfileState {
  double angle_rad = 0.0;
  double speed_rad_s = 0.0;
};

/// One step of a trapezoidal move towards the command's target. Speed never steps by more than the
/// slope allows, so a changed command goes on from the present speed.
ProfileState AdvanceProfile(const ProfileState& at, const MotorCommand& command,
                            const MotorModel& motor, double dt_s);

struct DriveOutput {
  double motor_torque_nm = 0.0;     // by current
  double friction_torque_nm = 0.0;  // gears and brake
  double current_a = 0.0;           // drawn, >= 0
  double torque_nm() const { return motor_torque_nm + friction_torque_nm; }
};

class MotorDrive {
 public:
  /// inertia_kg_m2: what the shaft turns against the stator with no load; tunes servo and bristles.
  MotorDrive(const MotorModel& motor, double inertia_kg_m2);

  /// Torque on the shaft for the next step. Throws std::invalid_argument for a command that is not
  /// finite.
  DriveOutput Step(const MotorCommand& command, double angle_rad, double speed_rad_s, double dt_s);

  /// Angle of the power-on zero: Step's angles are counted from here on.
  void ResetProfile(double angle_rad) { profile_ = {angle_rad, 0.0}; }
  /// How far the profile went in the last step; a stalled shaft holds it back.
  double profile_moved_rad() const { return profile_moved_rad_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  double ServoTorque(const MotorCommand& command, double angle_rad, double speed_rad_s,
                     double dt_s);

  MotorModel motor_;
  ShaftBristle gears_, brake_;
  double servo_stiffness_nm_per_rad_ = 0.0, servo_damping_nms_per_rad_ = 0.0;
  MotorMode mode_ = MotorMode::kBrake;
  ProfileState profile_;
  double profile_moved_rad_ = 0.0;
  double gear_bend_rad_ = 0.0, brake_bend_rad_ = 0.0;
};

}  // namespace dockyard
