// The models of one scenario.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/custom/dock_model.h"
#include "models/custom/robot_model.h"
#include "models/parts/floor_model.h"
#include "models/parts/soil_model.h"
#include "sim/custom/custom_keys.h"

namespace dockyard::custom {

/// A floor, or a soil that yields.
struct GroundModel {
  FloorModel floor;  // where there is a soil, its friction alone
  std::optional<SoilModel> soil;
};

struct ModelSet {
  RobotModel robot;
  DockModel dock;
  GroundModel ground;
};

struct CustomModels {
  CustomKeys keys;
  ModelSet nominal;  // what the controller gets
  ModelSet built;    // what the world is made of; equal unless the scenario has `as_built`
  std::vector<std::string> doubts;  // what is odd about them (findings.h)
};

}  // namespace dockyard::custom
