#include "sim/raposa/load_models.h"

#include "models/raposa/load_ground.h"
#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "models/read/config_error.h"
#include "models/read/yaml_path.h"

namespace dockyard::raposa {
namespace {

void RequireFiles(const Scenario& scenario) {
  if (scenario.robot_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'robot', RAPOSA's file, found none");
  }
  if (scenario.soil_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'soil', a ground's file, found none");
  }
  if (!scenario.camera_file.empty()) {
    throw ConfigError(scenario.camera_place +
                      ": expected no camera.file: RAPOSA's camera stands in its robot's file");
  }
  if (scenario.image_width != 0 || scenario.image_height != 0) {
    throw ConfigError(scenario.camera_place +
                      ": expected no width_px or height_px: they stand in the robot's file");
  }
}

void CheckRoots(const YamlNode& changes, const std::string& root) {
  if (changes.kind == YamlNode::Kind::kNull) return;
  const YamlReader known(changes, root, {"robot", "pyramid", "soil"});
  for (const char* model : {"robot.spreads", "pyramid.spreads", "soil.spreads"}) {
    const YamlNode* value = FindPath(changes, model);
    if (value == nullptr) continue;
    throw ConfigError(value->place.Text() + ": " + root + "." + model +
                      ": expected none; spreads are read from the model's own file");
  }
}

ModelSet LoadSet(const Scenario& scenario, const RaposaKeys& keys, const YamlNode& built) {
  const auto changes = [&](const char* model) {
    return ModelChanges{scenario.changes.Find(model), built.Find(model)};
  };
  return {LoadRobot(scenario.robot_file, changes("robot")),
          LoadPyramid(keys.pyramid_file, changes("pyramid")),
          LoadGround(scenario.soil_file, changes("soil"))};
}

}  // namespace

RaposaModels LoadModels(const Scenario& scenario) {
  RequireFiles(scenario);
  RaposaModels models;
  models.keys = ReadRaposaKeys(scenario);
  CheckRoots(scenario.changes, "changes");
  CheckRoots(scenario.as_built, "as_built");
  models.told = LoadSet(scenario, models.keys, {});
  models.built = models.told;
  if (scenario.as_built.kind != YamlNode::Kind::kNull) {
    models.built = LoadSet(scenario, models.keys, scenario.as_built);
  }
  return models;
}

}  // namespace dockyard::raposa
