// Commands of a robot's controller: to motors, for images, and to switches such as lamps.
#pragma once

#include <cstdint>
#include <vector>

#include "controller/io/sensors.h"

namespace dockyard {

/// Modes of a motor drive. Every move follows a trapezoidal speed profile run by the drive.
enum class MotorMode : std::uint8_t {
  kFree,      // no current; gear friction stays
  kBrake,     // friction brake on; the shaft holds up to the brake's torque
  kVelocity,  // run at target [rad/s]
  kPosition,  // go to target [rad since power-on] and hold it by current
};

/// All values at the output shaft, signs as the encoder counts. The current limit bounds the
/// drive's torque: a larger load turns the shaft off its profile.
struct MotorCommand {
  MotorMode mode = MotorMode::kBrake;
  double target = 0.0;             // [rad] or [rad/s]
  double speed_limit_rad_s = 0.0;  // kPosition: cruise speed, >= 0
  double accel_rad_s2 = 0.0;       // slope of the profile, > 0 in kVelocity and kPosition
  double current_limit_a = 0.0;    // >= 0; the motor's own limit also holds

  bool operator==(const MotorCommand&) const = default;
};

/// The controller's own verdict on its task. Scoring uses it only to name a false claim.
enum class Verdict : std::uint8_t { kUnderWay, kDone, kGivenUp };

/// The most stops off that a controller may ask for, either way; assumed, 4-8: an electronic
/// shutter spans more than 16 stops in all.
inline constexpr double kMostExposure_stops = 6.0;

struct Commands {
  std::vector<MotorCommand> motors{};    // one for each of the robot's motors, in their order
  std::vector<int> take_images{};        // cameras whose image the next frame brings, or
                                         // a later one, or none: cameras may be slow or fail
  double exposure_stops = 0.0;           // of take_images, as a power of two off the exposure that
                                         // the cameras choose by themselves; +1: twice the light
  std::vector<std::uint8_t> switches{};  // lamps and the like, by index: 1 on, 0 off
  Verdict verdict = Verdict::kUnderWay;

  bool operator==(const Commands&) const = default;
};

}  // namespace dockyard
