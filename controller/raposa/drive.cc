#include "controller/raposa/drive.h"

#include <algorithm>
#include <cmath>

#include "controller/raposa/odometry.h"

namespace dockyard::raposa {
namespace {

MotorCommand Position(const NominalMotor& motor, double target_rad, double speed_rad_s) {
  return {.mode = MotorMode::kPosition,
          .target = target_rad,
          .speed_limit_rad_s = std::min(speed_rad_s, motor.max_speed_rad_s),
          .accel_rad_s2 = motor.max_accel_rad_s2,
          .current_limit_a = motor.max_current_a};
}

std::size_t Index(Motor motor) { return static_cast<std::size_t>(motor); }

}  // namespace

void SetBelts(const Nominal& nominal, const Twist& twist_N, Commands* commands) {
  const BeltSpeeds speeds = SpeedsOfBelts(nominal, twist_N);
  const auto run = [&](Motor belt, double rad_s) {
    const NominalMotor& motor = nominal.motors[Index(belt)];
    commands->motors[Index(belt)] = {
        .mode = MotorMode::kVelocity,
        .target = std::clamp(rad_s, -motor.max_speed_rad_s, motor.max_speed_rad_s),
        .speed_limit_rad_s = 0.0,
        .accel_rad_s2 = motor.max_accel_rad_s2,
        .current_limit_a = motor.max_current_a};
  };
  run(Motor::kLeftBelt, speeds.left_rad_s);
  run(Motor::kRightBelt, speeds.right_rad_s);
}

void SetArm(const Nominal& nominal, double angle_rad, Commands* commands) {
  const NominalMotor& motor = nominal.motors[Index(Motor::kArm)];
  commands->motors[Index(Motor::kArm)] = Position(motor, angle_rad, motor.max_speed_rad_s);
}

void CloseDoors(const Nominal& nominal, double seconds, Commands* commands) {
  const double closed_rad = nominal.door_travel_m / nominal.door_pinion_radius_m;
  for (const Motor door : {Motor::kLeftDoor, Motor::kRightDoor}) {
    commands->motors[Index(door)] =
        Position(nominal.motors[Index(door)], closed_rad, closed_rad / seconds);
  }
}

void SetDoors(const Nominal& nominal, double opening_m, Commands* commands) {
  const double angle_rad = (nominal.door_travel_m - opening_m) / nominal.door_pinion_radius_m;
  for (const Motor door : {Motor::kLeftDoor, Motor::kRightDoor}) {
    const NominalMotor& motor = nominal.motors[Index(door)];
    commands->motors[Index(door)] = Position(motor, angle_rad, motor.max_speed_rad_s);
  }
}

}  // namespace dockyard::raposa
