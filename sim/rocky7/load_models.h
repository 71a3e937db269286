// The models that a scenario of Rocky 7 names.
#pragma once

#include "models/parts/soil_model.h"
#include "models/rocky7/robot_model.h"
#include "sim/rocky7/rocky7_keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::rocky7 {

struct ModelSet {
  RobotModel robot;
  SoilModel soil;
};

struct Rocky7Models {
  Rocky7Keys keys;
  ModelSet nominal;  // the values that the controller gets
  ModelSet built;    // what the world is made of; equal unless the scenario has `as_built`
};

/// Reads the files and applies the scenario's changes. Throws ConfigError.
Rocky7Models LoadModels(const Scenario& scenario);

}  // namespace dockyard::rocky7
