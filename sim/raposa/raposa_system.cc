#include "sim/raposa/raposa_system.h"

#include <cmath>

#include "models/raposa/load_ground.h"
#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "models/read/load_model_yaml.h"
#include "models/read/yaml_reader.h"
#include "sim/raposa/load_models.h"
#include "sim/raposa/nominal_json.h"
#include "sim/raposa/raposa_columns.h"
#include "sim/raposa/raposa_judge.h"
#include "sim/raposa/raposa_keys.h"
#include "sim/raposa/raposa_plant.h"
#include "sim/raposa/view_start.h"

namespace dockyard::raposa {
namespace {

/// Motors in the order of Motor.
ReadyRun PartsOf(const Nominal& nominal) {
  const char* const names[kMotorCount] = {"left_belt", "right_belt", "arm", "left_door",
                                          "right_door"};
  ReadyRun ready;
  ready.control_period = kControlPeriod;
  ready.motor_count = kMotorCount;
  ready.camera_count = kCameraCount;
  ready.switch_count = kSwitchCount;
  for (std::size_t i = 0; i < kMotorCount; ++i) {
    ready.motors.push_back({names[i], nominal.motors[i].rad_per_count});
  }
  ready.cameras = {{"back", nominal.camera, nominal.X_RC}};
  return ready;
}

std::string Check(const Scenario& scenario, const RaposaModels& models) {
  BuildRun(scenario, models);
  return models.nominal.robot.name + " from " + NumberText(scenario.start.on_plane().r) + " m to " +
         models.nominal.pyramid.name + " on " + models.nominal.ground.name;
}

std::optional<FileCheck> CheckModelFile(const std::string& file) {
  const YamlNode root = LoadModelYaml(file);
  if (root.Find("belts") != nullptr) {
    const RobotModel robot = LoadRobot(file);
    return FileCheck{"tracked robot",
                     robot.name + ": " + NumberText(std::round(1e3 * robot.mass_kg()) / 1e3) +
                         " kg, belts " + NumberText(robot.belts.gauge_m) + " m apart"};
  }
  if (root.Find("guide") != nullptr) {
    const PyramidModel pyramid = LoadPyramid(file);
    return FileCheck{"pyramid", pyramid.name + ": " + NumberText(pyramid.body.mass_kg) +
                                    " kg, guide " + NumberText(pyramid.guide.height_m) +
                                    " m above the ground"};
  }
  if (root.Find("rolling_loss") != nullptr) {
    const GroundModel ground = LoadGround(file);
    return FileCheck{"ground for belts", ground.name};
  }
  return std::nullopt;
}

}  // namespace

System RaposaSystem(const std::vector<NamedController<Nominal>>& controllers,
                    const std::vector<SystemCommand>& commands, const SystemCommand& detect) {
  System system;
  system.name = "raposa";
  system.controllers = EntriesOf(controllers, NominalFromJson);
  system.scenario.file_keys = {"pyramid"};
  system.scenario.changes_file_keys = {"robot.urdf", "pyramid.urdf"};
  system.scenario.model_roots = {
      {"robot", "robot"}, {"pyramid", "raposa.pyramid"}, {"soil", "soil"}};
  system.columns = {OutcomeNames(), ChannelsOf<Truth>(), Beliefs(), Measures()};
  system.keys = VisitOf(VisitRaposaKeys);
  UseModels(
      std::make_shared<ModelStore<RaposaModels>>(LoadModels),
      {Check, MakeReady<RaposaPlant, RaposaJudge, PartsOf>, WriteStartView, ShapesOf<RaposaPlant>},
      system);
  system.files = {.check = CheckModelFile,
                  .keys = {{"robot", VisitRobotKeys}, {"pyramid", VisitPyramidKeys}}};
  system.example_files.scenario = "scenarios/raposa_point_9.yaml";
  system.example_files.campaign = "scenarios/raposa_grid.yaml";
  system.example_files.robot = "models/raposa/raposa.yaml";
  system.example_files.reproduction = "raposa2009";
  system.example_files.start_images = "5204f86ec478904d";
  system.reproductions = {{"raposa2009", "scenarios/raposa2009_published.yaml",
                           "The 64 trials of Ferreira and Ventura (2009) from the 16 points of "
                           "their Table I, driven by a controller as they describe theirs."}};
  system.commands = commands;
  system.detect = detect;
  return system;
}

}  // namespace dockyard::raposa
