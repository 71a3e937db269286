// The models that a scenario names.
#pragma once

#include <optional>
#include <vector>

#include "models/custom/dock_model.h"
#include "models/custom/robot_model.h"
#include "models/parts/floor_model.h"
#include "models/parts/soil_model.h"
#include "models/read/as_built.h"
#include "models/read/mesh_loader.h"
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

/// A file of models/floors or of models/soils. Throws ConfigError.
GroundModel LoadGround(const std::string& file, const ModelChanges& changes = {});

/// Reads the files and applies the scenario's changes. Throws ConfigError, also for models that can
/// never dock.
CustomModels LoadModels(const Scenario& scenario, MeshStore* meshes = nullptr);

}  // namespace dockyard::custom
