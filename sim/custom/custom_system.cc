#include "sim/custom/custom_system.h"

#include <cmath>

#include "models/custom/load_dock.h"
#include "models/custom/load_robot.h"
#include "models/custom/make_nominal.h"
#include "models/read/config_error.h"
#include "models/read/load_floor.h"
#include "models/read/load_model_yaml.h"
#include "models/read/yaml_reader.h"
#include "sim/custom/custom_columns.h"
#include "sim/custom/custom_judge.h"
#include "sim/custom/custom_keys.h"
#include "sim/custom/custom_plant.h"
#include "sim/custom/findings.h"
#include "sim/custom/load_models.h"
#include "sim/custom/nominal_json.h"
#include "sim/custom/view_start.h"

namespace dockyard::custom {
namespace {

ReadyRun MakeReadyRun(const Scenario& scenario, const CustomModels& models,
                      const std::shared_ptr<KeptRenderer>& renderer) {
  auto plant = std::make_unique<CustomPlant>(scenario, BuildRun(scenario, models), renderer);
  const BuiltRun& built = plant->built();
  ReadyRun ready;
  ready.control_period = kControlPeriod;
  ready.nominal = ToJson(built.nominal);
  ready.motor_count = static_cast<int>(built.nominal.motors.size());
  ready.camera_count = static_cast<int>(built.nominal.cameras.size());
  ready.sensors = SensorsOf(models.nominal.robot, built.world.contacts);
  for (const JointDrive& drive : built.nominal.motors) {
    ready.motors.push_back({drive.joint, drive.motor.rad_per_count});
  }
  for (std::size_t i = 0; i < built.nominal.cameras.size(); ++i) {
    const CameraFit& fit = models.nominal.robot.cameras[i];
    const std::string body =
        fit.link == 0 ? "robot" : "robot/" + models.nominal.robot.tree.link(fit.link).name;
    ready.cameras.push_back({fit.model.name, fit.model.nominal, fit.model.X_LC, body});
    ready.camera_times.push_back({std::llround(fit.model.period_s / kTickSeconds),
                                  std::llround(fit.model.latency_s / kTickSeconds)});
  }
  ready.judge = std::make_unique<CustomJudge>(*plant);
  ready.plant = std::move(plant);
  return ready;
}

double Rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

std::string Check(const Scenario& scenario, const CustomModels& models) {
  BuildRun(scenario, models);
  const ModelSet& drawn = models.nominal;
  return drawn.robot.name + " from " + NumberText(Rounded(scenario.start.on_plane().r, 1e3)) +
         " m to " + drawn.dock.name + " on " + drawn.ground.floor.name;
}

std::optional<FileCheck> CheckModelFile(const std::string& file) {
  const YamlNode root = LoadModelYaml(file);
  if (IsRobotFile(root)) {
    const RobotModel robot = LoadRobot(file);
    const Findings findings = FindInRobot(robot, file);
    RequireNoFault(findings);
    return FileCheck{"robot",
                     robot.name + ": " + NumberText(Rounded(robot.tree.mass_kg(), 1e3)) + " kg, " +
                         std::to_string(robot.wheels.size()) + " wheels, " +
                         std::to_string(robot.motors.size()) + " motors, " +
                         std::to_string(robot.cameras.size()) + " cameras",
                     findings.doubts};
  }
  if (IsDockFile(root)) {
    const DockModel dock = LoadDock(file);
    const Findings findings = FindInDock(dock, file);
    RequireNoFault(findings);
    return FileCheck{"dock",
                     dock.name + ": " + NumberText(Rounded(dock.tree.mass_kg(), 1e3)) + " kg, " +
                         (dock.fixed ? "fixed" : "on the floor") + ", " +
                         std::to_string(dock.boards.size()) + " boards, " +
                         std::to_string(dock.electrical.pins.size() + dock.electrical.pads.size()) +
                         " pins and pads",
                     findings.doubts};
  }
  if (root.Find("rolling_resistance_m") != nullptr && root.Find("friction") != nullptr) {
    return FileCheck{"floor", LoadFloor(file).name};
  }
  return std::nullopt;
}

std::optional<std::vector<PlacedCamera>> CamerasOf(const std::string& file) {
  if (!IsRobotFile(LoadModelYaml(file))) return std::nullopt;
  std::vector<PlacedCamera> cameras;
  const Nominal nominal = MakeNominal(LoadRobot(file), {});
  for (const RobotCamera& camera : nominal.cameras) {
    cameras.push_back({camera.name, camera.camera, camera.X_RC});
  }
  return cameras;
}

std::optional<NamedBoard> BoardOf(const std::string& file) {
  if (!IsDockFile(LoadModelYaml(file))) return std::nullopt;
  const DockModel dock = LoadDock(file);
  if (dock.boards.size() != 1) {
    throw ConfigError(file + ": boards: expected one board, found " +
                      std::to_string(dock.boards.size()) + "; give the file of one of them");
  }
  return NamedBoard{dock.boards[0].name, dock.boards[0].board};
}

}  // namespace

void RefuseController(const std::string& controller, const std::string& reason) {
  throw ConfigError("controller " + controller + ": " + reason);
}

System CustomSystem(const std::vector<NamedController<Nominal>>& controllers) {
  System system;
  system.name = "custom";
  system.controllers = EntriesOf(controllers, NominalFromJson);
  system.scenario.file_keys = {"dock"};
  system.scenario.changes_file_keys = {"robot.urdf", "dock.urdf"};
  system.scenario.model_roots = {{"robot", "robot"}, {"dock", "custom.dock"}, {"soil", "soil"}};
  system.scenario.root_keys = {"dock", "judge", "graceful"};
  system.columns = {OutcomeNames(), ChannelsOf<Truth>(), Beliefs(), Measures()};
  system.keys = VisitOf(VisitCustomKeys);
  const auto store = std::make_shared<ModelStore<CustomModels>>(LoadModels);
  UseModels(store, {Check, MakeReadyRun, WriteStartView, ShapesOf<CustomPlant>}, system);
  system.doubts = [store](const Scenario& scenario) { return store->Get(scenario)->doubts; };
  // A controller that cannot drive the robot is refused by `check` already.
  system.check = [models = system.check, ready = system.make_ready,
                  made = system.controllers](const Scenario& scenario) {
    const std::string line = models(scenario);
    for (const ControllerEntry& entry : made) {
      if (scenario.command.empty() && entry.name == scenario.controller) {
        entry.make(ready(scenario).nominal);
      }
    }
    return line;
  };
  system.files = {.check = CheckModelFile,
                  .cameras = CamerasOf,
                  .board = BoardOf,
                  .keys = {{"robot", VisitRobotKeys}, {"dock", VisitDockKeys}}};
  system.example_files.scenario = "examples/docks/charger/scenario.yaml";
  system.example_files.robot = "examples/docks/charger/robot/robot.yaml";
  system.example_files.target = "examples/docks/charger/dock/dock.yaml";
  system.example_files.start_images = "be8793acf95daac8";
  return system;
}

}  // namespace dockyard::custom
