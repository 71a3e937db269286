#include "sim/rocky7/rocky7_system.h"

#include <cmath>

#include "models/read/load_model_yaml.h"
#include "models/read/yaml_reader.h"
#include "models/rocky7/load_robot.h"
#include "sim/rocky7/load_models.h"
#include "sim/rocky7/nominal_json.h"
#include "sim/rocky7/rocky7_columns.h"
#include "sim/rocky7/rocky7_judge.h"
#include "sim/rocky7/rocky7_keys.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/rocky7/view_start.h"

namespace dockyard::rocky7 {
namespace {

constexpr const char* kMastHead = "mast_link_2";  // the body K: RoverShapes names it

ReadyRun PartsOf(const Nominal& nominal) {
  ReadyRun ready;
  ready.control_period = kControlPeriod;
  ready.success_word = Name(SuccessOf(nominal.task));
  ready.motor_count = static_cast<int>(nominal.motors.size());
  ready.camera_count = kCameraCount;
  for (int i = 0; i < kContactCount; ++i) {
    ready.sensors.push_back({.name = "face_switch_" + std::to_string(i),
                             .unit = "",
                             .meaning = "contact switch of the instrument's face, 1 closed",
                             .period = kControlPeriod});
  }
  std::size_t motor = 0;
  for (const WheelPlan& wheel : nominal.plan.wheels) {
    ready.motors.push_back({wheel.name, nominal.motors[motor++].rad_per_count});
  }
  for (const WheelPlan& wheel : nominal.plan.wheels) {
    if (wheel.steer_limit_rad == 0.0) continue;
    ready.motors.push_back({wheel.name + "_steering", nominal.motors[motor++].rad_per_count});
  }
  for (const char* name : {"arm_roll", "arm_pitch", "front_scoop", "back_scoop", "mast_roll",
                           "mast_shoulder", "mast_elbow"}) {
    ready.motors.push_back({name, nominal.motors[motor++].rad_per_count});
  }
  ready.cameras = {{"front_left", nominal.front.left, nominal.front.X_RL},
                   {"front_right", nominal.front.right, nominal.front.X_RQ},
                   {"mast_left", nominal.mast.pair_K.left, nominal.mast.pair_K.X_RL, kMastHead},
                   {"mast_right", nominal.mast.pair_K.right, nominal.mast.pair_K.X_RQ, kMastHead},
                   {"back_left", nominal.back.left, nominal.back.X_RL},
                   {"back_right", nominal.back.right, nominal.back.X_RQ}};
  return ready;
}

std::string Check(const Scenario& scenario, const Rocky7Models& models) {
  BuildRun(scenario, models);
  const double width_m =
      models.keys.task == Task::kPlace ? models.keys.boulder_m : models.keys.diameter_m;
  return models.nominal.robot.rover.plan.name + " from " + NumberText(scenario.start.on_plane().r) +
         " m to a stone of " + NumberText(1e3 * width_m) + " mm on " + models.nominal.soil.name;
}

bool IsRobotFile(const std::string& file) {
  const YamlNode root = LoadModelYaml(file);
  return root.Find("steer_rate_deg_s") != nullptr && root.Find("cameras") != nullptr;
}

std::optional<FileCheck> CheckModelFile(const std::string& file) {
  if (!IsRobotFile(file)) return std::nullopt;
  const RobotModel robot = LoadRobot(file);
  return FileCheck{"rover on wheels with cameras",
                   robot.rover.plan.name + ": " +
                       NumberText(std::round(1e2 * robot.rover.mass_kg()) / 1e2) +
                       " kg, front pair of " + NumberText(robot.front.nominal.baseline_m()) + " m"};
}

std::optional<StereoRig> RigOf(const std::string& file, int width, int height) {
  if (!IsRobotFile(file)) return std::nullopt;
  StereoRig rig = LoadRobot(file).front.nominal;
  if (width > 0) {
    rig.left = Resized(rig.left, width, height);
    rig.right = Resized(rig.right, width, height);
  }
  return rig;
}

}  // namespace

System Rocky7System(const std::vector<NamedController<Nominal>>& controllers) {
  System system;
  system.name = "rocky7";
  system.controllers = EntriesOf(controllers, NominalFromJson);
  system.scenario.model_roots = {{"robot", "robot"}, {"soil", "soil"}};
  system.scenario.rocks = true;
  system.columns = {OutcomeNames(), ChannelsOf<Truth>(), Beliefs(), Measures()};
  system.keys = VisitOf(VisitRocky7Keys);
  UseModels(
      std::make_shared<ModelStore<Rocky7Models>>(
          [](const Scenario& scenario, MeshStore*) { return LoadModels(scenario); }),
      {Check, MakeReady<Rocky7Plant, Rocky7Judge, PartsOf>, WriteStartView, ShapesOf<Rocky7Plant>},
      system);
  system.files = {.check = CheckModelFile, .rig = RigOf, .keys = {{"robot", VisitRobotKeys}}};
  system.example_files.scenario = "scenarios/rocky7_reach.yaml";
  system.example_files.robot = "models/rocky7/rocky7.yaml";
  system.example_files.reproduction = "rocky7";
  system.example_files.start_images = "2f769a5b8b78c191";
  system.reproductions = {
      {"rocky7", "scenarios/rocky7_published.yaml",
       "The 25 grasps and 14 tracking sequences of Nesnas, Maimone and Das (2000), "
       "by a controller as they describe theirs; starts, stones and light are ours."}};
  return system;
}

}  // namespace dockyard::rocky7
