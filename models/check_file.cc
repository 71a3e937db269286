#include "models/check_file.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "models/config_error.h"
#include "models/load_board.h"
#include "models/load_cameras.h"
#include "models/load_rover.h"
#include "models/load_scenario.h"
#include "models/load_soil.h"
#include "models/load_station.h"
#include "models/load_wheel.h"
#include "models/mesh_loader.h"
#include "models/study.h"
#include "models/urdf.h"
#include "models/yaml_reader.h"

namespace dockyard {
namespace {

FileCheck CheckMesh(const std::string& file) {
  const auto mesh = LoadMesh(file);
  return {"mesh", std::to_string(mesh->vertices.size()) + " vertices, " +
                      std::to_string(mesh->triangles.size()) + " triangles"};
}

FileCheck CheckUrdf(const std::string& file) {
  const UrdfModel model = LoadUrdf(file);
  double mass_kg = 0.0;
  for (const LinkModel& link : model.links) mass_kg += link.mass_kg;
  return {"urdf", model.name + ": " + std::to_string(model.links.size()) + " links, " +
                      std::to_string(model.joints.size()) + " joints, " + NumberText(mass_kg) +
                      " kg"};
}

FileCheck CheckRover(const std::string& file) {
  const RoverModel rover = LoadRover(file);
  return {"rover", rover.name + ": " + NumberText(rover.mass_kg()) + " kg, arm " +
                       NumberText(rover.arm_length_m) + " m, stereo baseline " +
                       NumberText(rover.stereo.nominal.baseline_m()) + " m"};
}

FileCheck CheckStation(const std::string& file) {
  const StationModel station = LoadStation(file);
  return {"station", station.name + ": " + NumberText(station.module.mass_kg) + " kg on " +
                         std::to_string(station.feet.size()) + " feet, " +
                         std::to_string(station.board.fiducials.size()) + " fiducials, cone " +
                         NumberText(station.mouth_height_m) + " m above the ground"};
}

FileCheck CheckBoard(const std::string& file) {
  const NamedBoard named = LoadBoard(file);
  return {"board", named.name + ": " + std::to_string(named.board.fiducials.size()) +
                       (named.board.HasBars() ? " discs with bars, " : " plain discs, ") +
                       NumberText(named.board.width_m) + " x " + NumberText(named.board.height_m) +
                       " m"};
}

FileCheck CheckSoil(const std::string& file) {
  const SoilModel soil = LoadSoil(file);
  return {"soil", soil.name + ": n " + NumberText(soil.n) + ", k_phi " + NumberText(soil.k_phi) +
                      ", cohesion " + NumberText(soil.cohesion_pa) + " Pa"};
}

FileCheck CheckWheel(const std::string& file) {
  const WheelFile wheel = LoadWheel(file);
  return {"wheel", wheel.name + ": radius " + NumberText(wheel.wheel.rim_radius_m) + " m, width " +
                       NumberText(wheel.wheel.width_m) + " m, " +
                       std::to_string(wheel.wheel.paddle_count) + " paddles"};
}

FileCheck CheckScenario(const std::string& file) {
  const Scenario scenario = LoadScenario(file);
  const ScenarioModels models = LoadModels(scenario);
  return {"scenario", scenario.name + ": " + models.rover.name + " from " +
                          NumberText(scenario.start.r_m) + " m to " + models.station.name + " on " +
                          models.soil.name + ", controller " + scenario.controller};
}

FileCheck CheckCampaign(const std::string& file) {
  const Campaign campaign = LoadCampaign(file);
  std::set<std::string> soils;  // one scenario for each soil reaches every file that is named
  for (const CampaignRun& run : campaign.runs) {
    if (soils.insert(run.soil).second) LoadModels(run.scenario);
  }
  return {"campaign", campaign.name + ": " + std::to_string(campaign.runs.size()) + " runs on " +
                          std::to_string(soils.size()) + " soils, seed " +
                          std::to_string(campaign.seed)};
}

FileCheck CheckStudy(const std::string& file) {
  const Study study = LoadStudy(file);
  return {"study",
          study.name + ": " + std::to_string(study.points.size()) + " points, " +
              std::to_string(study.points.size() * static_cast<std::size_t>(study.repeats)) +
              " runs"};
}

FileCheck CheckCameras(const std::string& file) {
  const std::vector<PlacedCamera> cameras = LoadCameras(file);
  for (const PlacedCamera& placed : cameras) {
    RequireRays(placed.name.empty() ? file : file + ": " + placed.name, placed.camera);
  }
  const Camera& first = cameras[0].camera;
  const Eigen::Vector2d f = first.focal_px();
  std::string summary = std::to_string(cameras.size()) +
                        (cameras.size() == 1 ? " camera, " : " cameras, the first of ") +
                        std::to_string(first.width) + " x " + std::to_string(first.height) +
                        " px, " + NumberText(std::round(10.0 * f.x()) / 10.0) + " px/rad";
  return {"camera", summary};
}

FileCheck CheckRig(const std::string& file) {
  const StereoRig rig = LoadRig(file);
  return {"rig", std::to_string(rig.left.width) + " x " + std::to_string(rig.left.height) +
                     " px, baseline " + NumberText(std::round(1e4 * rig.baseline_m()) / 1e4) +
                     " m"};
}

FileCheck CheckYaml(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  const auto has = [&](const char* key) { return root.Find(key) != nullptr; };
  if (has("study")) return CheckStudy(file);
  if (has("campaign") || has("runs") || has("table")) return CheckCampaign(file);
  if (has("start") || has("rover") || has("station")) return CheckScenario(file);
  if (has("wheels") || has("motors") || has("cameras")) return CheckRover(file);
  if (has("left") || has("right")) return CheckRig(file);
  if (has("model")) return CheckCameras(file);
  if (IsBoardFile(root)) return CheckBoard(file);
  if (has("cone") || has("board") || has("feet")) return CheckStation(file);
  if (has("k_phi") || has("cohesion_pa") || has("friction_angle_deg")) return CheckSoil(file);
  if (has("radius_m") || has("width_m") || has("paddles")) return CheckWheel(file);
  throw ConfigError(
      root.place.Text() +
      ": expected the keys of a rover, station, board, soil, wheel, camera, rig, scenario, "
      "campaign or study, found "
      "none of them");
}

FileCheck CheckTable(const std::string& file) {
  return {"campaign table", std::to_string(CheckCampaignTable(file)) + " runs"};
}

}  // namespace

FileCheck CheckFile(const std::string& file) {
  if (std::filesystem::is_directory(file)) {
    throw ConfigError(file + ": expected a file, found a folder");
  }
  const std::string extension = std::filesystem::path(file).extension().string();
  if (IsMeshFile(file)) return CheckMesh(file);
  if (extension == ".urdf") return CheckUrdf(file);
  if (extension == ".json") return CheckCameras(file);
  if (extension == ".csv") return CheckTable(file);
  if (extension == ".yaml" || extension == ".yml") return CheckYaml(file);
  throw ConfigError(
      file +
      ": expected a file .yaml, .yml, .json, .csv, .urdf, .stl, .obj, .dae, .gltf or .glb, found "
      "extension '" +
      extension + "'");
}

}  // namespace dockyard
