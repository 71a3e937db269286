#include "sim/rocky7/load_models.h"

#include "models/read/config_error.h"
#include "models/read/load_soil.h"
#include "models/read/yaml_path.h"
#include "models/rocky7/load_robot.h"

namespace dockyard::rocky7 {
namespace {

void RequireFiles(const Scenario& scenario) {
  if (scenario.robot_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'robot', Rocky 7's file, found none");
  }
  if (scenario.soil_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'soil', a soil's file, found none");
  }
  if (!scenario.camera_file.empty()) {
    throw ConfigError(scenario.camera_place +
                      ": expected no camera.file: Rocky 7's cameras stand in its robot's file");
  }
  if (scenario.image_width != 0 || scenario.image_height != 0) {
    throw ConfigError(scenario.camera_place +
                      ": expected no width_px or height_px: Rocky 7's pictures are 640 x 480");
  }
}

void CheckRoots(const YamlNode& changes, const std::string& root) {
  if (changes.kind == YamlNode::Kind::kNull) return;
  const YamlReader known(changes, root, {"robot", "soil"});
  for (const char* model : {"robot.spreads", "soil.spreads"}) {
    const YamlNode* value = FindPath(changes, model);
    if (value == nullptr) continue;
    throw ConfigError(value->place.Text() + ": " + root + "." + model +
                      ": expected none; spreads are read from the model's own file");
  }
}

ModelSet LoadSet(const Scenario& scenario, const YamlNode& built) {
  const auto changes = [&](const char* model) {
    return ModelChanges{scenario.changes.Find(model), built.Find(model)};
  };
  return {LoadRobot(scenario.robot_file, changes("robot")),
          LoadSoil(scenario.soil_file, changes("soil"))};
}

}  // namespace

Rocky7Models LoadModels(const Scenario& scenario) {
  RequireFiles(scenario);
  Rocky7Models models;
  models.keys = ReadRocky7Keys(scenario);
  CheckRoots(scenario.changes, "changes");
  CheckRoots(scenario.as_built, "as_built");
  models.told = LoadSet(scenario, {});
  models.built = models.told;
  if (scenario.as_built.kind != YamlNode::Kind::kNull) {
    models.built = LoadSet(scenario, scenario.as_built);
  }
  return models;
}

}  // namespace dockyard::rocky7
