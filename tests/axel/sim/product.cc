#include "axel/sim/product.h"

#include <cmath>
#include <string>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/read/load_soil.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

std::string Model(const char* name) { return SourceFile("models/") + name; }

}  // namespace

RoverModel Axel() { return LoadRover(Model("axel/axel.yaml")); }

StationModel Station() { return LoadStation(Model("axel/station/station.yaml")); }

SoilModel LooseSand() { return LoadSoil(Model("soils/loose_sand.yaml")); }

SoilModel CompactGravel() { return LoadSoil(Model("soils/compact_gravel.yaml")); }

WorldSetup TestSetup(const SoilModel& soil, const Pose2& X_DR) {
  WorldSetup setup;
  setup.rover = Axel();
  setup.station = Station();
  setup.soil = soil;
  setup.ground = LevelGrid(-1.5, 8.5, 6.0, 0.02);
  setup.X_DR_start = X_DR;
  setup.arm_start_rad = setup.rover.arm_at_power_on_rad;
  return setup;
}

MotorCommands AllBraked() { return {}; }

MotorCommand Velocity(double rad_s, double current_a) {
  return {MotorMode::kVelocity, rad_s, 0.0, 1.0, current_a};
}

MotorCommand Position(double rad, double rad_s, double current_a) {
  return {MotorMode::kPosition, rad, rad_s, 1.0, current_a};
}

MotorCommand FreeWheel() { return {MotorMode::kFree, 0.0, 0.0, 0.0, 0.0}; }

double SpoolCurrent(double tension_n) {
  // Axel's spool: 0.2 A of no load, 10 N m/A, a drum of 60 mm (models/axel/axel.yaml).
  return 0.2 + tension_n * 0.06 / 10.0;
}

MotorCommands Drive(double rad_s, double tension_n) {
  MotorCommands commands = AllBraked();
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = Velocity(rad_s, 2.8);
  At(commands, Motor::kArm) = Position(0.0, 0.3, 2.2);
  if (tension_n > 0.0) At(commands, Motor::kSpool) = Velocity(0.8, SpoolCurrent(tension_n));
  return commands;
}

MotorCommands Reel(double tension_limit_n) {
  MotorCommands commands = Drive(0.0, tension_limit_n);
  At(commands, Motor::kLeftWheel) = At(commands, Motor::kRightWheel) = FreeWheel();
  return commands;
}

void Play(World& world, const MotorCommands& commands, double seconds, double step_s) {
  const long steps = std::lround(seconds / step_s);
  for (long i = 0; i < steps; ++i) world.Step(commands);
}

}  // namespace dockyard::axel
