// Rocky 7's cameras, contact switches and control period. Its motors: the wheels' drives in the
// order of its plan, then the steering of those wheels that steer, in the same order, then the
// arm's (ArmMotor), then the mast's (MastMotor).
#pragma once

#include <cstdint>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

/// The front body pair, the mast's pair and the back body pair.
inline constexpr int kFrontLeft = 0, kFrontRight = 1, kMastLeft = 2, kMastRight = 3, kBackLeft = 4,
                     kBackRight = 5, kCameraCount = 6;

/// The arm's motors, counted from its first. Their angles count from the arm's zero, straight ahead
/// and level: the joints are homed at power-on. Positive: shoulder roll about x, pitch lowering the
/// arm's end, a scoop's lip moving backwards, towards the shoulder.
enum class ArmMotor : std::uint8_t { kRoll, kPitch, kFrontScoop, kBackScoop };
inline constexpr int kArmMotorCount = 4;

/// The mast's motors, counted from its first. Their angles count from the mast's zero: both links
/// straight ahead and level. Positive: roll to the left about the body's z, shoulder and elbow
/// lowering what hangs on them.
enum class MastMotor : std::uint8_t { kRoll, kShoulder, kElbow };
inline constexpr int kMastMotorCount = 3;

/// The contact switches on the instrument's face, about the tool's axis: above it, and 120 deg to
/// the left and right of that, as the mast sees it.
inline constexpr int kContactCount = 3;

/// Assumed, 20-100 ms: the rover's computer gives its drives positions and reads them.
inline constexpr Tick kControlPeriod = 50;

}  // namespace dockyard::rocky7
