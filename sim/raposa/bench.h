// The world without a controller: commands for its motors, for trials of single parts.
#pragma once

#include <array>
#include <string>

#include "sim/raposa/world.h"

namespace dockyard::raposa {

using MotorCommands = std::array<MotorCommand, kMotorCount>;

/// On a level ground, the camera r from the guide and facing it. Belts without errors of their
/// readings.
WorldSetup OnLevelGround(const RobotModel& robot, const PyramidModel& pyramid,
                         const GroundModel& ground, double r_m, double alpha_rad = 0.0);

MotorCommand Run(const WorldSetup& setup, Motor motor, double rad_s);
MotorCommand GoTo(const WorldSetup& setup, Motor motor, double rad);
/// Belts at these speeds of their surfaces, all else braked. Positive drives towards the arm.
MotorCommands Belts(const WorldSetup& setup, double left_m_s, double right_m_s);
void Play(World& world, const WorldSetup& setup, const MotorCommands& commands, double seconds);

}  // namespace dockyard::raposa
