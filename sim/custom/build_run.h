// A run as it is built from its scenario.
#pragma once

#include "controller/custom/nominal/nominal.h"
#include "sim/custom/load_models.h"
#include "sim/custom/world.h"
#include "sim/log/named_sensor.h"
#include "sim/plant/light.h"

namespace dockyard::custom {

inline constexpr Tick kControlPeriod = 20;

struct BuiltRun {
  WorldSetup world;  // G is D
  JudgeKeys judge;
  FloorModel floor;  // for images
  Lighting lighting;
  Nominal nominal;  // what the controller gets
};

/// Sensors of one number: switches, then range finders, then voltage and current of each electrical
/// contact.
std::vector<NamedSensor> SensorsOf(const RobotModel& robot,
                                   const std::vector<std::string>& contacts);

/// Throws ConfigError.
BuiltRun BuildRun(const Scenario& scenario, const CustomModels& models);

}  // namespace dockyard::custom
