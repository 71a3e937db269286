// Axel's motors and cameras by index, and its control period.
#pragma once

#include <cstdint>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

/// Always in this order. Wheels count up rolling forward, the arm counts up turning the tip down
/// against the body (about +y), the spool counts up reeling in.
enum class Motor : std::uint8_t { kLeftWheel, kRightWheel, kArm, kSpool };
inline constexpr int kMotorCount = 4;
inline constexpr int kLeftCamera = 0, kRightCamera = 1, kCameraCount = 2;

/// The controller is called every 20 ms (assumed; 10-100 ms is usual for rover flight software).
inline constexpr Tick kControlPeriod = 20;

/// All motors braked, no images.
inline Commands BrakedCommands() {
  Commands commands;
  commands.motors.resize(kMotorCount);
  return commands;
}

}  // namespace dockyard::axel
