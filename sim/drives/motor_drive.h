// A motor's drive at the output shaft: profile, servo within the current limit, gear friction in
// every mode, brake; between them and the output the gears' backlash and bend.
#pragma once

#include <cstdint>

#include "controller/io/commands.h"
#include "models/parts/motor.h"
#include "sim/drives/bristle.h"
#include "sim/rigid/profile.h"

namespace dockyard {

/// The gears' losses. i is the current beyond the no-load current, e the gears' efficiency, and e k
/// the model's torque per ampere. When the motor drives, the gears pass on e k i. When the load
/// drives them, they bear on their other flanks and hold against up to (2 - e) k i. So the loss is
/// friction in proportion to the load, and it also holds a resting shaft anywhere between the two.
struct DriveOutput {
  double motor_torque_nm = 0.0;     // k i, by current
  double friction_torque_nm = 0.0;  // gears and brake
  double current_a = 0.0;           // drawn, >= 0
  double lead_rad = 0.0;            // of the motor's side before the output
  double torque_nm() const { return motor_torque_nm + friction_torque_nm; }
};

class MotorDrive {
 public:
  /// inertia_kg_m2: what the shaft turns against the stator with no load; tunes servo and bristles.
  MotorDrive(const MotorModel& motor, double inertia_kg_m2);

  /// Torque on the output for the next step. The rotor's inertia counts with the output, so that
  /// backlash and bend are in balance at each moment. The command is finite.
  DriveOutput Step(const MotorCommand& command, double angle_rad, double speed_rad_s, double dt_s);

  /// Angle of the power-on zero: Step's angles are counted from here on.
  void ResetProfile(double angle_rad) { StartProfile(angle_rad + motor_.homing_error_rad, 0.0); }
  /// How far the profile went in the last step; a stalled shaft holds it back.
  double profile_moved_rad() const { return profile_moved_rad_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  double LosslessTorquePerAmp() const { return motor_.torque_per_amp_nm / motor_.gear_efficiency; }
  /// What servo, gears and brake change as they work.
  struct Working {
    ProfileState profile;
    bool on_move = false;  // whether profile is where move_ has it
    double gear_bend_rad = 0.0, brake_bend_rad = 0.0;
  };
  void StartProfile(double angle_rad, double speed_rad_s) {
    at_.profile = {angle_rad, speed_rad_s};
    at_.on_move = false;
  }
  void AdvanceAlong(const MotorCommand& command, double dt_s);
  double ServoTorque(const MotorCommand& command, double angle_rad, double speed_rad_s,
                     Working& at) const;
  /// Servo, gears and brake at this motion of the motor's side.
  DriveOutput Work(const MotorCommand& command, double angle_rad, double speed_rad_s, double dt_s,
                   Working& at) const;
  /// The motor's side before the output at which its torque is the one that the gears pass on.
  double Lead(const MotorCommand& command, double angle_rad, double speed_rad_s, double dt_s) const;

  MotorModel motor_;
  ShaftBristle gears_, brake_;
  double servo_stiffness_nm_per_rad_ = 0.0, servo_damping_nms_per_rad_ = 0.0;
  double bend_nm_per_rad_ = 0.0;  // 0: rigid, without backlash
  MotorMode mode_ = MotorMode::kBrake;
  Working at_;
  SplineMove move_;
  MotorCommand move_command_{};
  double move_time_s_ = 0.0;
  double profile_moved_rad_ = 0.0, lead_rad_ = 0.0;
};

}  // namespace dockyard
