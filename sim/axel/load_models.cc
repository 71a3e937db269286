#include "sim/axel/load_models.h"

#include <algorithm>
#include <cmath>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "models/read/load_soil.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {
namespace {

/// All that the models depend on, as text: equal text means equal models.
std::string ModelKey(const Scenario& scenario) {
  return scenario.robot_file + "\n" + scenario.soil_file + "\n" + scenario.camera_file + "\n" +
         std::to_string(scenario.image_width) + "x" + std::to_string(scenario.image_height) + "\n" +
         FlowText(scenario.of_system) + "\n" + FlowText(scenario.changes);
}

void RequireFiles(const Scenario& scenario) {
  if (scenario.robot_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'robot', Axel's file, found none");
  }
  if (scenario.soil_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'soil', a soil's file, found none");
  }
}

}  // namespace

AxelModels LoadModels(const Scenario& scenario, MeshStore* meshes) {
  RequireFiles(scenario);
  AxelModels models;
  models.keys = ReadAxelKeys(scenario);
  const YamlNode& changes = scenario.changes;
  if (changes.kind != YamlNode::Kind::kNull) {
    const YamlReader known(changes, "changes", {"robot", "station", "soil"});
  }
  models.rover = LoadRover(scenario.robot_file, scenario.image_width, scenario.image_height,
                           changes.Find("robot"), meshes);
  models.station = LoadStation(models.keys.station_file, changes.Find("station"), meshes);
  models.soil = LoadSoil(scenario.soil_file, changes.Find("soil"));
  CheckCarries(models.soil, scenario.soil_file, models.rover.left_wheel_soil);
  if (!scenario.camera_file.empty()) {
    models.rover.stereo.nominal =
        LoadRig(scenario.camera_file, scenario.image_width, scenario.image_height);
  }
  if (!std::isnan(models.keys.tip_angle_rad))
    models.station.tip_angle_rad = models.keys.tip_angle_rad;
  if (models.keys.vision.pipeline == VisionPipeline::kTsai2013 &&
      !HasTwoOfEachRotation(models.station.board)) {
    throw ConfigError(models.keys.station_file +
                      ": board: expected two bars of each rotation, as axel.vision.pipeline "
                      "tsai2013 needs them, found others");
  }
  if (models.rover.tip.radius_m >= models.station.cone.throat_radius_m) {
    throw ConfigError(models.keys.station_file + ": cone.throat_radius_m: expected more than the " +
                      NumberText(models.rover.tip.radius_m) + " m of the arm's tip in " +
                      scenario.robot_file + ", found '" +
                      NumberText(models.station.cone.throat_radius_m) + "'");
  }
  return models;
}

std::shared_ptr<const AxelModels> ModelStore::Get(const Scenario& scenario) {
  const std::string key = ModelKey(scenario);
  const auto known =
      std::find_if(sets_.begin(), sets_.end(), [&](const auto& set) { return set.first == key; });
  if (known != sets_.end()) return known->second;
  auto models = std::make_shared<const AxelModels>(LoadModels(scenario, &meshes_));
  if (sets_.size() >= kMostSets) sets_.erase(sets_.begin());
  sets_.emplace_back(key, models);
  return models;
}

}  // namespace dockyard::axel
