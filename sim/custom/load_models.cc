#include "sim/custom/load_models.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/custom/load_dock.h"
#include "models/custom/load_robot.h"
#include "models/read/config_error.h"
#include "models/read/load_floor.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_soil.h"
#include "models/read/near_names.h"
#include "sim/custom/docked_findings.h"
#include "sim/plant/model_files.h"
#include "sim/scenario/key_path.h"

namespace dockyard::custom {
namespace {

[[noreturn]] void RefuseName(const Scenario& scenario, const std::string& path,
                             const std::string& expected, const std::string& name,
                             const std::vector<std::string>& known) {
  const YamlNode* node = FindPath(scenario.of_system, path);
  throw ConfigError((node == nullptr ? scenario.of_system : *node).place.Text() + ": " + path +
                    ": expected " + expected + ", found '" + name + "'" +
                    DidYouMeanOrKnown(name, known));
}

void RequireFrameOf(const Scenario& scenario, const LinkTree& tree, const std::string& path,
                    const std::string& whose, const std::string& name) {
  if (tree.Frame(name) != nullptr) return;
  std::vector<std::string> known;
  for (const NamedFrame& frame : tree.frames) known.push_back(frame.name);
  RefuseName(scenario, path, "a link of the " + whose + "'s URDF file", name, known);
}

void RequireContact(const Scenario& scenario, const ModelSet& models, const std::string& path,
                    const std::string& name) {
  if (name.empty()) return;
  std::vector<std::string> known;
  for (const ElectricalParts* parts : {&models.robot.electrical, &models.dock.electrical}) {
    for (const SpringPin& pin : parts->pins) known.push_back(pin.contact);
  }
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  RefuseName(scenario, path, "the contact of some pins of robot or dock", name, known);
}

// Every pin needs a pad on the other side.
void CheckPads(const Scenario& scenario, const CustomKeys& keys, const ModelSet& models) {
  const auto check = [](const ElectricalParts& from, const ElectricalParts& on,
                        const std::string& whose, const std::string& other) {
    std::string there;
    for (const ContactPad& pad : on.pads)
      there += (there.empty() ? "" : ", ") + ("'" + pad.contact) + "' '" + pad.pole + "'";
    for (const SpringPin& pin : from.pins) {
      const bool met = std::any_of(on.pads.begin(), on.pads.end(), [&](const ContactPad& pad) {
        return pad.contact == pin.contact && pad.pole == pin.pole;
      });
      if (met) continue;
      throw ConfigError(whose + ": contact_pins: expected a pad of contact '" + pin.contact +
                        "' and pole '" + pin.pole + "' on " + other + ", found " +
                        (there.empty() ? "none" : there));
    }
  };
  check(models.robot.electrical, models.dock.electrical, scenario.robot_file, models.dock.name);
  check(models.dock.electrical, models.robot.electrical, keys.dock_file, models.robot.name);
}

}  // namespace

GroundModel LoadGround(const std::string& file, const ModelChanges& changes) {
  GroundModel ground;
  if (LoadModelYaml(file).Find("k_phi") == nullptr) {
    ground.floor = LoadFloor(file, changes);
    return ground;
  }
  ground.soil = LoadSoil(file, changes);
  ground.floor.name = ground.soil->name;
  ground.floor.friction = std::tan(ground.soil->friction_angle_rad);
  ground.floor.material = GroundMaterialKind::kSoil;
  ground.floor.grain = 1.0;
  return ground;
}

CustomModels LoadModels(const Scenario& scenario, MeshStore* meshes) {
  RequireFiles(scenario, "the", "a floor's or a soil's");
  RefuseCamera(scenario, "the robot's file has its cameras", "each camera has its own size");
  CustomModels models;
  models.keys = ReadCustomKeys(scenario);
  CheckRoots(scenario, {"robot", "dock", "soil"});
  LoadSets(
      scenario,
      [&](const auto& changes) {
        return ModelSet{LoadRobot(scenario.robot_file, changes("robot"), meshes),
                        LoadDock(models.keys.dock_file, changes("dock"), meshes),
                        LoadGround(scenario.soil_file, changes("soil"))};
      },
      models);
  const JudgeKeys& judge = models.keys.judge;
  RequireFrameOf(scenario, models.nominal.robot.tree, "judge.docked.pose.robot", "robot",
                 judge.docked.pose.robot);
  RequireFrameOf(scenario, models.nominal.dock.tree, "judge.docked.pose.dock", "dock",
                 judge.docked.pose.dock);
  RequireContact(scenario, models.nominal, "judge.docked.contact.pins", judge.docked.contact.pins);
  RequireContact(scenario, models.nominal, "judge.trial.contact.pins", judge.trial.contact.pins);
  CheckPads(scenario, models.keys, models.nominal);
  Findings findings = FindInScenario(scenario, models);
  RequireNoFault(findings);
  models.doubts = std::move(findings.doubts);
  return models;
}

}  // namespace dockyard::custom
