#include "sim/axel/axel_system.h"

#include <cmath>
#include <cstdio>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/axel/mating_fit.h"
#include "models/read/load_model_yaml.h"
#include "models/read/yaml_reader.h"
#include "sim/axel/axel_columns.h"
#include "sim/axel/axel_judge.h"
#include "sim/axel/axel_keys.h"
#include "sim/axel/axel_plant.h"
#include "sim/axel/build_rocks.h"
#include "sim/axel/load_models.h"
#include "sim/axel/nominal_json.h"
#include "sim/axel/read_script.h"
#include "sim/axel/tether_sensor.h"
#include "sim/axel/view_start.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/light.h"
#include "sim/plant/scenery.h"
#include "sim/scenario/rock_keys.h"

namespace dockyard::axel {
namespace {

/// Motors and cameras in the order of their numbers.
ReadyRun PartsOf(const Nominal& nominal) {
  const char* const names[kMotorCount] = {"left_wheel", "right_wheel", "arm", "spool"};
  ReadyRun ready;
  ready.control_period = kControlPeriod;
  ready.motor_count = kMotorCount;
  ready.camera_count = kCameraCount;
  for (std::size_t i = 0; i < kMotorCount; ++i) {
    ready.motors.push_back({names[i], nominal.motors[i].rad_per_count});
  }
  ready.cameras = {{"left", nominal.rig.left, nominal.rig.X_RL},
                   {"right", nominal.rig.right, nominal.rig.X_RQ}};
  if (nominal.tether_sensor) ready.sensors = SensorsOf(*nominal.tether_sensor);
  return ready;
}

StageShapes AxelShapes(const Scenario& scenario, const AxelModels& models) {
  const ModelSet& built = models.built;
  const Pose3 X_WG = SiteOf(scenario), X_WD = X_WG * FromGround(WorldSetup{}.X_GD, 0.0);
  Lighting lighting =
      MakeLighting(scenario.light, X_WD, BoardInDock(built.station).p, scenario.seed, scenario.sun);
  if (!scenario.scenery.empty()) {
    AddScenery(scenario, MakeGround(scenario.yard, scenario.seed), X_WG, WorldSetup{}.X_GD,
               lighting);
  }
  SceneBuilder scene(built.rover, built.station, built.soil, lighting, X_WG, scenario.seed);
  if (HasRocks(scenario, models)) {
    scene.AddRocks(BuildRocks(scenario, models, MakeGround(scenario.yard, scenario.seed)));
  }
  return scene.Shapes();
}

/// Where the arm would stand further askew in the socket than its play: a warning.
std::string Misfit(const RoverModel& rover, const StationModel& station) {
  const double axle_m = MeanAxleHeight(rover);
  const double askew_rad = SeatedElevation(rover, axle_m, station);
  const double play_rad = SeatedPlay(rover, station.cone);
  if (std::abs(askew_rad) <= play_rad) return {};
  const double fitting_m = FittingMouthHeight(rover, axle_m, station.cone, station.tip_angle_rad);
  char text[200];
  std::snprintf(text, sizeof text,
                "; the mouth is %.3f m high, %.3f m would fit the axle: the seated arm stands %.1f "
                "deg askew and has %.1f deg of play",
                station.mouth_height_m, fitting_m, Degrees(std::abs(askew_rad)), Degrees(play_rad));
  return text;
}

std::string Check(const Scenario& scenario, const AxelModels& models) {
  CheckImagesCanBeDrawn(models.built.rover.stereo.nominal, scenario.camera_place);
  CheckStationHolds(scenario, models.built.station);
  if (HasRocks(scenario, models)) {
    BuildRocks(scenario, models, MakeGround(scenario.yard, scenario.seed));
  }
  if (scenario.script.kind != YamlNode::Kind::kNull) ReadScript(scenario.script);
  return models.nominal.rover.name + " from " + NumberText(scenario.start.on_plane().r) + " m to " +
         models.nominal.station.name + " on " + models.nominal.soil.name +
         Misfit(models.nominal.rover, models.nominal.station);
}

bool IsRobotFile(const YamlNode& root) {
  const YamlNode* motors = root.Find("motors");
  const YamlNode* wheels = root.Find("wheels");  // other rovers have a list of them
  return (wheels != nullptr && wheels->kind != YamlNode::Kind::kSequence) ||
         (motors != nullptr &&
          (motors->Find("wheel") != nullptr || motors->Find("spool") != nullptr));
}

bool IsStationFile(const YamlNode& root) {
  return root.Find("cone") != nullptr || root.Find("board") != nullptr;
}

std::optional<FileCheck> CheckModelFile(const std::string& file, MeshStore& meshes) {
  const YamlNode root = LoadModelYaml(file);
  if (IsRobotFile(root)) {
    const RoverModel rover = LoadRover(file, 0, 0, {}, &meshes);
    std::string further;
    for (const JointedLink& each : rover.further.links) {
      further += (further.empty() ? "; further links: " : ", ") + each.link.name +
                 (each.motor ? " by a motor" : "");
    }
    return FileCheck{"rover", rover.name + ": " + NumberText(rover.mass_kg()) + " kg, arm " +
                                  NumberText(rover.arm_length_m) + " m, stereo baseline " +
                                  NumberText(rover.stereo.nominal.baseline_m()) + " m" + further};
  }
  if (!IsStationFile(root)) return std::nullopt;
  const StationModel station = LoadStation(file, {}, &meshes);
  return FileCheck{"station", station.name + ": " + NumberText(station.module.mass_kg) + " kg on " +
                                  std::to_string(station.feet.size()) + " feet, " +
                                  std::to_string(station.board.fiducials.size()) +
                                  " fiducials, cone " + NumberText(station.mouth_height_m) +
                                  " m above the ground"};
}

std::optional<StereoRig> RigOfRobot(const std::string& file, int width, int height,
                                    MeshStore& meshes) {
  if (!IsRobotFile(LoadModelYaml(file))) return std::nullopt;
  return LoadRover(file, width, height, {}, &meshes).stereo.nominal;
}

std::optional<NamedBoard> BoardOfStation(const std::string& file, MeshStore& meshes) {
  if (!IsStationFile(LoadModelYaml(file))) return std::nullopt;
  const StationModel station = LoadStation(file, {}, &meshes);
  return NamedBoard{.name = station.name, .board = station.board, .cutout = CutoutOf(station)};
}

}  // namespace

System AxelSystem(const std::vector<NamedController<Nominal>>& controllers,
                  const ScriptPlayer& play) {
  const auto store = std::make_shared<ModelStore<AxelModels>>(LoadModels, CheckBracket);
  System system;
  system.name = "axel";
  system.controllers = EntriesOf(controllers, NominalFromJson);
  system.scenario.file_keys = {"station"};
  system.scenario.changes_file_keys = {"robot.urdf", "robot.cameras.file", "station.urdf"};
  system.scenario.model_roots = {{"robot", "robot"}, {"station", "axel.station"}, {"soil", "soil"}};
  system.scenario.spoiled_pictures = true;
  system.scenario.rocks = true;
  system.columns = {OutcomeNames(), ChannelsOf<Truth>(), Beliefs(), Measures()};
  system.keys = VisitOf(VisitAxelKeys);
  UseModels(store, {Check, MakeReady<AxelPlant, AxelJudge, PartsOf>, WriteStartView, AxelShapes},
            system);
  system.play = [play](const Json& nominal, const YamlNode& script) {
    return play(NominalFromJson(nominal), ReadScript(script));
  };
  system.files = {
      .check = [store](const std::string& file) { return CheckModelFile(file, store->meshes()); },
      .rig = [store](const std::string& file, int width,
                     int height) { return RigOfRobot(file, width, height, store->meshes()); },
      .board = [store](const std::string& file) { return BoardOfStation(file, store->meshes()); },
      .keys = {{"robot", VisitRoverKeys}, {"station", VisitStationKeys}}};
  system.example_files = {.scenario = "scenarios/axel_typical.yaml",
                          .campaign = "scenarios/mars_yard_40.yaml",
                          .sweep = "scenarios/studies/reel_alpha.yaml",
                          .robot = "models/axel/axel.yaml",
                          .target = "models/axel/station/station.yaml",
                          .cameras = "models/cameras/axel_1024.yaml",
                          .reproduction = "axel2013",
                          .start_images = "65aebefd521771f2"};
  system.reproductions = {{"axel2013", "scenarios/axel2013_published.yaml",
                           "The 40 docking runs of Tsai et al. 2013 in the Mars Yard, driven by a "
                           "controller as they describe theirs, and pure reeling beside them."}};
  return system;
}

}  // namespace dockyard::axel
