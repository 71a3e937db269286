// The example charger: its models, scenario and world.
#pragma once

#include <string>

#include "models/custom/load_dock.h"
#include "models/custom/load_robot.h"
#include "sim/custom/build_run.h"
#include "sim/custom/custom_system.h"
#include "sim/custom/load_models.h"
#include "sim/scenario/load_scenario.h"
#include "support/source_tree.h"

namespace dockyard::custom {

inline std::string ChargerFile(const std::string& name) {
  return SourceFile("examples/docks/charger/" + name);
}

inline Scenario ChargerScenario(const std::vector<std::string>& overrides = {}) {
  const System system = CustomSystem({});
  KnownSystem known = system.scenario;
  known.name = system.name;
  known.controllers = {"graceful"};
  return LoadScenario(ChargerFile("scenario.yaml"), overrides, {known});
}

inline WorldSetup ChargerWorld(const std::vector<std::string>& overrides = {}) {
  const Scenario scenario = ChargerScenario(overrides);
  return BuildRun(scenario, LoadModels(scenario)).world;
}

/// Both driven wheels at speeds of their treads.
inline std::vector<MotorCommand> DriveAt(const WorldSetup& setup, double left_m_s,
                                         double right_m_s) {
  std::vector<MotorCommand> commands;
  for (const double speed : {left_m_s, right_m_s}) {
    const MotorModel& motor = setup.robot.motors[commands.size()].model;
    commands.push_back({.mode = MotorMode::kVelocity,
                        .target = speed / setup.robot.wheels[0].tyre.radius_m,
                        .speed_limit_rad_s = 0.0,
                        .accel_rad_s2 = motor.max_accel_rad_s2,
                        .current_limit_a = motor.max_current_a});
  }
  return commands;
}

inline void RunFor(World& world, double seconds, const std::vector<MotorCommand>& commands,
                   const Eigen::Vector3d& push_G = {0, 0, 0}) {
  const Tick until = world.tick() + std::llround(1e3 * seconds);
  while (world.tick() < until) world.Step(commands, push_G);
}

}  // namespace dockyard::custom
