// Rocky 7's cameras and its control period. Its motors: the wheels' drives in the order of its
// plan, then the steering of those wheels that steer, in the same order, then the arm's (ArmMotor).
#pragma once

#include <cstdint>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

/// The front body pair.
inline constexpr int kFrontLeft = 0, kFrontRight = 1, kCameraCount = 2;

/// The arm's motors, counted from its first. Their angles count from the arm's zero, straight ahead
/// and level: the joints are homed at power-on. Positive: shoulder roll about x, pitch lowering the
/// arm's end, a scoop's lip moving backwards, towards the shoulder.
enum class ArmMotor : std::uint8_t { kRoll, kPitch, kFrontScoop, kBackScoop };
inline constexpr int kArmMotorCount = 4;

/// Assumed, 20-100 ms: the rover's computer gives its drives positions and reads them.
inline constexpr Tick kControlPeriod = 50;

}  // namespace dockyard::rocky7
