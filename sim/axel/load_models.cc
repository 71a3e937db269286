#include "sim/axel/load_models.h"

#include <cmath>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/axel/own_view.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "models/read/load_soil.h"
#include "models/read/read_stereo.h"
#include "models/read/yaml_path.h"
#include "models/read/yaml_reader.h"
#include "sim/plant/model_files.h"
#include "sim/scenario/key_path.h"

namespace dockyard::axel {
namespace {

/// Keys of a scenario that stand for a model's own, as changes to it.
YamlNode ChangesOf(const Scenario& scenario, const AxelKeys& keys) {
  YamlNode changes = scenario.changes;
  if (std::isnan(keys.tip_angle_rad)) return changes;
  const YamlNode& angle = *scenario.of_system.Find("tip_angle_deg");
  if (changes.kind == YamlNode::Kind::kNull) changes.kind = YamlNode::Kind::kMapping;
  PutPath(changes, "station.tip_angle_deg", angle.place, angle);
  return changes;
}

/// What a world cannot be built otherwise than told.
void CheckAsBuilt(const Scenario& scenario) {
  const YamlNode& built = scenario.as_built;
  for (const char* text : {"robot.name", "station.name", "soil.name", "soil.source"}) {
    RefuseKey(built, "as_built", text, "keys that something is built by, a name is not");
  }
  for (const char* phase : {"left_phase_deg", "right_phase_deg"}) {
    RefuseKey(built, "as_built", std::string("robot.wheels.") + phase,
              "none; how the wheels stand is drawn for each run");
  }
  for (const char* noise : {"tension_noise_n", "direction_noise_deg"}) {
    RefuseKey(built, "as_built", std::string("robot.tether_sensor.") + noise,
              "none; the noise is the nominal one");
  }
  RefuseKey(built, "as_built", "robot.arm.at_power_on_deg",
            "none; the arm lies on the ground at power-on");
  if (scenario.camera_file.empty()) return;
  for (const char* key :
       {"file", "baseline_m", "forward_m", "height_m", "pitch_deg", "field_of_view_deg"}) {
    RefuseKey(built, "as_built", std::string("robot.cameras.") + key,
              "none beside camera.file, which sets it; robot.cameras.mounting moves the pair");
  }
}

void CheckTogether(const Scenario& scenario, const AxelKeys& keys, const ModelSet& set) {
  CheckCarries(set.soil, scenario.soil_file, set.rover.left_wheel_soil.width_m);
  if (set.rover.tip.radius_m < set.station.cone.throat_radius_m) return;
  throw ConfigError(keys.station_file + ": cone.throat_radius_m: expected more than the " +
                    NumberText(set.rover.tip.radius_m) + " m of the arm's tip in " +
                    scenario.robot_file + ", found '" +
                    NumberText(set.station.cone.throat_radius_m) + "'");
}

/// Of a pair that the scenario names in place of the robot's own.
void RequireView(const Scenario& scenario, const RoverModel& rover) {
  const std::string blinded = BlindedBy(rover);
  if (blinded.empty()) return;
  throw ConfigError(scenario.camera_place +
                    ": expected cameras with at most half of an image filled by the rover's own "
                    "body, found " +
                    blinded);
}

/// The models with the keys of `told` on top, and those of `built` on top of that where there are
/// any: `base` holds the models without them.
ModelSet LoadSet(const Scenario& scenario, const AxelKeys& keys, const YamlNode& told,
                 const YamlNode& built, const ModelSet* base, MeshStore* meshes) {
  const auto changes = [&](const char* model) {
    return ModelChanges{told.Find(model), built.Find(model)};
  };
  ModelSet set;
  if (base != nullptr) set = *base;
  if (base == nullptr || built.Find("robot") != nullptr) {
    set.rover = LoadRover(scenario.robot_file, scenario.image_width, scenario.image_height,
                          changes("robot"), meshes);
    StereoModel& stereo = set.rover.stereo;
    if (!scenario.camera_file.empty()) {
      stereo.nominal = MountedRig(
          LoadRig(scenario.camera_file, scenario.image_width, scenario.image_height), stereo);
      RequireView(scenario, set.rover);
    }
  }
  if (base == nullptr || built.Find("station") != nullptr) {
    // The mouth fits the rover that is told, not the one that is built.
    const RoverModel& told_rover = base != nullptr ? base->rover : set.rover;
    set.station = LoadStation(keys.station_file, changes("station"), meshes, &told_rover);
  }
  if (base == nullptr || built.Find("soil") != nullptr) {
    set.soil = LoadSoil(scenario.soil_file, changes("soil"));
  }
  CheckTogether(scenario, keys, set);
  return set;
}

}  // namespace

std::string WhyNoBracket(const Scenario& scenario, const AxelModels& models) {
  if (models.keys.vision.pipeline == VisionPipeline::kTsai2013) {
    return "beside axel.vision.pipeline tsai2013, which is held as flown";
  }
  if (scenario.command.empty() && !scenario.controller.empty() &&
      scenario.controller != "dockyard") {
    return "beside controller " + scenario.controller + ", which takes no bracket";
  }
  for (const ModelSet* set : {&models.nominal, &models.built}) {
    if (set->rover.stereo.sensor.exposure.rule == ExposureRule::kBracketed) {
      return "beside the robot's cameras.sensor.exposure.rule bracketed, as cameras that change "
             "their exposure by themselves cannot be merged";
    }
  }
  return "";
}

void CheckBracket(const Scenario& scenario, const AxelModels& models) {
  if (!(models.keys.bracket_stops > 0.0)) return;
  const std::string why = WhyNoBracket(scenario, models);
  if (why.empty()) return;
  throw ConfigError(FindPath(scenario.of_system, "vision.bracket_stops")->place.Text() +
                    ": axel.vision.bracket_stops: expected 0 " + why);
}

AxelModels LoadModels(const Scenario& scenario, MeshStore* meshes) {
  RequireFiles(scenario, "Axel's");
  AxelModels models;
  models.keys = ReadAxelKeys(scenario);
  CheckRoots(scenario, {"robot", "station", "soil"});
  CheckAsBuilt(scenario);
  const YamlNode changes = ChangesOf(scenario, models.keys);
  models.nominal = LoadSet(scenario, models.keys, changes, {}, nullptr, meshes);
  models.built =
      LoadSet(scenario, models.keys, changes, scenario.as_built, &models.nominal, meshes);
  if (models.built.rover.tether_sensor && !models.nominal.rover.tether_sensor) {
    RefuseKey(scenario.as_built, "as_built", "robot.tether_sensor",
              "none; the robot has no such sensor");
  }
  const std::size_t marks = models.nominal.station.board.fiducials.size();
  if (models.built.station.board.fiducials.size() != marks) {
    RefuseKey(scenario.as_built, "as_built", "station.board",
              "as many fiducials as are told, " + std::to_string(marks));
  }
  if (models.keys.vision.pipeline == VisionPipeline::kTsai2013 &&
      !HasTwoOfEachRotation(models.nominal.station.board)) {
    throw ConfigError(models.keys.station_file +
                      ": board: expected two bars of each rotation, as axel.vision.pipeline "
                      "tsai2013 needs them, found others");
  }
  CheckBracket(scenario, models);
  return models;
}

}  // namespace dockyard::axel
