#include "controller/raposa/drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/raposa/odometry.h"

namespace dockyard::raposa {
namespace {

std::size_t Index(Motor motor) { return static_cast<std::size_t>(motor); }

void GoTo(const Nominal& nominal, Motor motor, double target_rad, Commands* commands,
          double speed_rad_s = std::numeric_limits<double>::max()) {
  const NominalMotor& limits = nominal.motors[Index(motor)];
  commands->motors[Index(motor)] = {.mode = MotorMode::kPosition,
                                    .target = target_rad,
                                    .speed_limit_rad_s = speed_rad_s,
                                    .accel_rad_s2 = limits.max_accel_rad_s2,
                                    .current_limit_a = limits.max_current_a};
}

}  // namespace

void SetBelts(const Nominal& nominal, const Twist& twist_N, Commands* commands) {
  const BeltSpeeds speeds = SpeedsOfBelts(nominal, twist_N);
  for (const Motor belt : {Motor::kLeftBelt, Motor::kRightBelt}) {
    const NominalMotor& limits = nominal.motors[Index(belt)];
    commands->motors[Index(belt)] = {
        .mode = MotorMode::kVelocity,
        .target = belt == Motor::kLeftBelt ? speeds.left_rad_s : speeds.right_rad_s,
        .accel_rad_s2 = limits.max_accel_rad_s2,
        .current_limit_a = limits.max_current_a};
  }
}

Twist TurnAt(double left_rad, double most_rad_s, const DockyardOptions& options) {
  const double rate = std::clamp(options.turn_gain_per_s * left_rad, -most_rad_s, most_rad_s);
  return {0.0, std::copysign(std::max(std::abs(rate), options.least_turn_rad_s), rate)};
}

double PressAngle(const DockyardOptions& options, int tries) {
  if (tries == 0) return options.press_rad;
  return options.press_rad + (tries % 2 == 1 ? -1.0 : 1.0) * options.press_other_rad;
}

void SetArm(const Nominal& nominal, double angle_rad, Commands* commands) {
  GoTo(nominal, Motor::kArm, angle_rad, commands);
}

void CloseDoors(const Nominal& nominal, double seconds, Commands* commands) {
  const double closed_rad = nominal.door_travel_m / nominal.door_pinion_radius_m;
  for (const Motor door : {Motor::kLeftDoor, Motor::kRightDoor}) {
    GoTo(nominal, door, closed_rad, commands, closed_rad / seconds);
  }
}

void SetDoors(const Nominal& nominal, double opening_m, Commands* commands) {
  const double angle_rad = (nominal.door_travel_m - opening_m) / nominal.door_pinion_radius_m;
  for (const Motor door : {Motor::kLeftDoor, Motor::kRightDoor}) {
    GoTo(nominal, door, angle_rad, commands);
  }
}

}  // namespace dockyard::raposa
