// The rover, station and soils that the program runs, from models/, for tests of the world. A test
// that needs another number changes it itself.
#pragma once

#include "sim/axel/world.h"

namespace dockyard::axel {

RoverModel Axel();          // models/axel/axel.yaml
StationModel Station();     // models/axel/station/station.yaml
SoilModel LooseSand();      // models/soils/loose_sand.yaml
SoilModel CompactGravel();  // models/soils/compact_gravel.yaml

/// The rover on level ground at X_DR, arm level, dock at the site's origin.
WorldSetup TestSetup(const SoilModel& soil, const Pose2& X_DR);

/// Commands for all four motors.
using MotorCommands = std::array<MotorCommand, kMotorCount>;
MotorCommands AllBraked();
MotorCommand Velocity(double rad_s, double current_a);
MotorCommand Position(double rad, double rad_s, double current_a);
MotorCommand FreeWheel();
/// The current at which Axel's spool pulls with this tension when it stands.
double SpoolCurrent(double tension_n);
/// Both wheels at this speed, the arm held; the spool pulls with up to tension_n, if above 0.
MotorCommands Drive(double rad_s, double tension_n);
/// Free wheels, the spool reels with up to this tension.
MotorCommands Reel(double tension_limit_n);
inline MotorCommand& At(MotorCommands& commands, Motor motor) {
  return commands[static_cast<std::size_t>(motor)];
}

void Play(World& world, const MotorCommands& commands, double seconds, double step_s = 1e-3);

}  // namespace dockyard::axel
