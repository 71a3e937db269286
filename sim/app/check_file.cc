#include "sim/app/check_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "models/read/calibrations.h"
#include "models/read/config_error.h"
#include "models/read/load_board.h"
#include "models/read/load_cameras.h"
#include "models/read/load_floor.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_obstacles.h"
#include "models/read/load_rover.h"
#include "models/read/load_soil.h"
#include "models/read/load_wheel.h"
#include "models/read/mesh_loader.h"
#include "models/read/mesh_size.h"
#include "models/read/xacro.h"
#include "models/read/yaml_reader.h"
#include "sim/app/check_answer.h"
#include "sim/app/check_cameras.h"
#include "sim/app/check_urdf.h"
#include "sim/app/reproduction_files.h"
#include "sim/app/scenario_options.h"
#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

FileCheck CheckMesh(const std::string& file) {
  const auto mesh = LoadMesh(file);
  const Eigen::Vector3d extent_m = ExtentOf(*mesh);
  FileCheck check{"mesh", CountText(mesh->vertices.size(), "vertex", "vertices") + ", " +
                              CountText(mesh->triangles.size(), "triangle") + ", " +
                              SizeText(extent_m) + " (x, y, z)"};
  if (const std::string doubt = UnitDoubt(extent_m); !doubt.empty()) check.warnings = {doubt};
  return check;
}

FileCheck CheckBoard(const std::string& file) {
  const NamedBoard named = LoadBoard(file);
  if (const std::vector<SquareTag>& tags = named.board.tags; !tags.empty()) {
    return {"board", named.name + ": " + CountText(tags.size(), "tag") + " of " + tags[0].family +
                         ", " + NumberText(named.board.width_m) + " x " +
                         NumberText(named.board.height_m) + " m"};
  }
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

FileCheck CheckFloor(const std::string& file) {
  const FloorModel floor = LoadFloor(file);
  return {"floor", floor.name + ": friction " + NumberText(floor.friction) +
                       ", rolling resistance " + NumberText(floor.rolling_resistance_m) + " m"};
}

FileCheck CheckWheel(const std::string& file) {
  const WheelFile wheel = LoadWheel(file);
  return {"wheel", wheel.name + ": radius " + NumberText(wheel.wheel.rim_radius_m) + " m, width " +
                       NumberText(wheel.wheel.width_m) + " m, " +
                       CountText(wheel.wheel.paddle_count, "paddle")};
}

FileCheck CheckRover(const std::string& file, bool is_built) {
  const RoverPlan rover = LoadRoverPlan(file);
  const auto steered =
      std::count_if(rover.wheels.begin(), rover.wheels.end(),
                    [](const WheelPlan& wheel) { return wheel.steer_limit_rad > 0.0; });
  std::string found = rover.name + ": " + CountText(rover.wheels.size(), "wheel") + ", " +
                      std::to_string(steered) + " of them steered";
  if (is_built)
    found += ", " + NumberText(std::round(100.0 * LoadRover(file).mass_kg()) / 100.0) + " kg";
  return {"rover on wheels", found};
}

FileCheck CheckObstacles(const std::string& file) {
  const Obstacles obstacles = LoadObstacles(file);
  return {"obstacles", CountText(obstacles.discs.size(), "disc") + ", " +
                           CountText(obstacles.polygons.size(), "area")};
}

/// Each once: the runs of a campaign share them.
void AddDoubts(const System& system, const Scenario& scenario, std::vector<std::string>& warnings) {
  if (!system.doubts) return;
  for (const std::string& text : system.doubts(scenario)) {
    if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
      warnings.push_back(text);
  }
}

FileCheck CheckScenario(const std::string& file, const std::vector<System>& systems) {
  const Scenario scenario = LoadScenario(file, {}, KnownSystems(systems));
  const System& system = FindSystem(systems, scenario.system);
  const std::string found = system.check(scenario);
  NamedUrdfs urdfs;
  urdfs.AddScenario(scenario, system);
  FileCheck check{"scenario", scenario.name + ": " + found + ", controller " + scenario.controller};
  AddDoubts(system, scenario, check.warnings);
  return WithUrdfs(urdfs, check);
}

FileCheck CheckCampaign(const std::string& file, const std::vector<System>& systems) {
  const Campaign campaign = LoadCampaign(file, {}, CampaignSystemsOf(systems));
  NamedUrdfs urdfs;
  std::vector<std::string> doubts;
  CheckRuns(campaign, KnownSystems(systems), [&](const Scenario& scenario) {
    const System& system = FindSystem(systems, scenario.system);
    system.check(scenario);
    AddDoubts(system, scenario, doubts);
    urdfs.AddScenario(scenario, system);
  });
  const std::string labels = Listed(campaign.labels);
  return WithUrdfs(urdfs, {"campaign",
                           campaign.name + ": " + CountText(campaign.run_count(), "run") +
                               (labels.empty() ? "" : " by " + labels) + "; seed " +
                               std::to_string(campaign.seed.number),
                           std::move(doubts)});
}

FileCheck CheckReproduction(const std::string& file, const std::vector<System>& systems) {
  const Published published = LoadPublished(file);
  std::vector<CampaignNames> names;
  for (const PublishedCampaign& campaign : published.campaigns) {
    names.push_back(NamesOf(LoadCampaign(campaign.file, {}, CampaignSystemsOf(systems)), systems));
  }
  CheckPublished(published, names);
  return {"published experiment", published.name + ": " + CountText(published.rows.size(), "row") +
                                      ", " + std::to_string(published.judged.size()) +
                                      " of them judged beside the total"};
}

FileCheck CheckTable(const std::string& file) {
  const TableCheck table = CheckRunTable(file);
  const auto list = [](const std::vector<std::string>& names) {
    return names.empty() ? "none" : Listed(names);
  };
  return {"campaign table", CountText(table.runs, "run") + "; checked: " + list(table.checked) +
                                "; left to the campaign's file: " + list(table.left_to_campaign)};
}

FileCheck CheckYaml(const std::string& file, const std::vector<System>& systems) {
  const YamlNode root = LoadCameraTree(file);  // YAML, also with the marks of OpenCV
  if (IsCalibration(root)) return CheckCalibration(file);
  const auto has = [&](const char* key) { return root.Find(key) != nullptr; };
  if (has("reproduction")) return CheckReproduction(file, systems);
  if (has("obstacles")) return CheckObstacles(file);
  if (has("steer_rate_deg_s")) return CheckRover(file, has("build"));
  if (has("campaign") || has("study") || has("runs") || has("table"))
    return CheckCampaign(file, systems);
  if (has("system") || has("start")) return CheckScenario(file, systems);
  if (IsBoardFile(root)) return CheckBoard(file);
  const YamlNode model = LoadModelYaml(file);
  for (const System& system : systems) {
    if (!system.files.check) continue;
    const std::optional<FileCheck> check = system.files.check(file);
    if (!check) continue;
    NamedUrdfs urdfs;
    urdfs.AddModel(file);
    return WithUrdfs(urdfs, *check);
  }
  if (has("left") || has("right")) return CheckRig(file);
  if (has("model")) return CheckCameras(file);
  if (model.Find("k_phi") || model.Find("cohesion_pa") || model.Find("friction_angle_deg")) {
    return CheckSoil(file);
  }
  if (model.Find("friction") && model.Find("grain")) return CheckFloor(file);
  if (has("radius_m") || has("width_m") || has("paddles")) return CheckWheel(file);
  throw ConfigError(root.place.Text() +
                    ": expected the keys of a scenario, campaign, published experiment, board, "
                    "soil, floor, wheel, camera, rig, rover on wheels, obstacles "
                    "or of a system's own model, found none of them");
}

bool IsUrdfFile(const std::string& file) {
  return std::filesystem::path(file).extension() == ".urdf" || IsXacroFile(file);
}

}  // namespace

FileCheck CheckFile(const std::string& file, const std::vector<System>& systems,
                    const CheckOptions& options) {
  if (NamesTwoFiles(file)) return CheckRig(file);
  if (std::filesystem::is_directory(file)) {
    throw ConfigError(file + ": expected a file, found a folder");
  }
  const std::string extension = std::filesystem::path(file).extension().string();
  if (IsMeshFile(file)) return CheckMesh(file);
  if (IsUrdfFile(file)) return CheckUrdf(file, options.packages);
  if (extension == ".json" || extension == ".xml") return CheckCameras(file);
  if (extension == ".csv") return IsDiscTable(file) ? CheckObstacles(file) : CheckTable(file);
  if (extension == ".yaml" || extension == ".yml") return CheckYaml(file, systems);
  throw ConfigError(
      file +
      ": expected a file .yaml, .yml, .json, .xml, .csv, .urdf, .xacro, .stl, .obj, .dae, .gltf or "
      ".glb, found extension '" +
      extension + "'");
}

UrdfFindings FindFaults(const std::string& file, const std::vector<System>& systems,
                        const CheckOptions& options) {
  if (IsUrdfFile(file)) return FindUrdfFaults(file, UrdfCheckOptions(options.packages));
  try {
    CheckFile(file, systems, options);
  } catch (const ConfigError& error) {
    // The fault may lie in a URDF file that this one names, which has more of them.
    const std::string urdf = PlaceOf(error.what(), file).file;
    UrdfFindings found;
    if (IsUrdfFile(urdf) && !IsMeshFile(file)) found = FindUrdfFaults(urdf, {});
    if (found.faults.empty()) found.faults = {error.what()};
    return found;
  }
  return {};
}

}  // namespace dockyard
