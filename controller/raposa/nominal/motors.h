// RAPOSA's motors, camera and switches by index, and its control period.
#pragma once

#include <cstdint>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard::raposa {

/// Always in this order. Belts count up driving the robot towards its arm, away from a pyramid
/// behind it; the arm counts up turning its tip down against the body (about +y); doors count up
/// closing.
enum class Motor : std::uint8_t { kLeftBelt, kRightBelt, kArm, kLeftDoor, kRightDoor };
inline constexpr int kMotorCount = 5;
inline constexpr int kBackCamera = 0, kCameraCount = 1;
inline constexpr int kLamps = 0, kSwitchCount = 1;

/// The controller is called at the camera's rate and asks for a picture each time. Assumed,
/// 67-200 ms; encoders of the successor's robot are read every 100 ms as well.
inline constexpr Tick kControlPeriod = 100;

/// All motors braked, lamps off, no picture.
inline Commands BrakedCommands() {
  Commands commands;
  commands.motors.resize(kMotorCount);
  commands.switches.resize(kSwitchCount);
  return commands;
}

}  // namespace dockyard::raposa
