// What the rover's brain can ask for: four motors and a pair of pictures.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "controller/io/sensors.h"

namespace dockyard {

/// Modes of a motor drive. Every move follows a trapezoidal speed profile run by the drive.
enum class MotorMode : std::uint8_t {
  kFree,      // no current; gear friction stays
  kBrake,     // friction brake on; the shaft holds up to the brake's torque
  kVelocity,  // run at target [rad/s]
  kPosition,  // go to target [rad since power-on] and hold it by current
};

/// All values at the output shaft, signs as in SensorFrame::encoder_counts. The current limit
/// bounds the drive's torque: overpowered, the shaft is dragged off its profile (a spool pays out).
struct MotorCommand {
  MotorMode mode = MotorMode::kBrake;
  double target = 0.0;             // [rad] or [rad/s]
  double speed_limit_rad_s = 0.0;  // kPosition: cruise speed, >= 0
  double accel_rad_s2 = 0.0;       // slope of the profile, > 0 in kVelocity and kPosition
  double current_limit_a = 0.0;    // >= 0; the motor's own limit also holds

  bool operator==(const MotorCommand&) const = default;
};

/// What the brain says of the docking; scoring never uses it but to name a false claim.
enum class Verdict : std::uint8_t { kUnderWay, kDocked, kGivenUp };

struct Commands {
  std::array<MotorCommand, kMotorCount> motors{};  // by Motor
  bool take_images = false;                        // the next frame brings a pair
  Verdict verdict = Verdict::kUnderWay;

  bool operator==(const Commands&) const = default;
};

}  // namespace dockyard
