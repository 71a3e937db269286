#include "sim/app/check_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "models/read/calibrations.h"
#include "models/read/config_error.h"
#include "models/read/load_board.h"
#include "models/read/load_cameras.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_obstacles.h"
#include "models/read/load_rover.h"
#include "models/read/load_soil.h"
#include "models/read/load_wheel.h"
#include "models/read/mesh_loader.h"
#include "models/read/mesh_size.h"
#include "models/read/urdf_weld.h"
#include "models/read/xacro.h"
#include "models/read/yaml_reader.h"
#include "sim/app/check_answer.h"
#include "sim/app/check_cameras.h"
#include "sim/app/reproduction_files.h"
#include "sim/app/scenario_options.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

FileCheck CheckMesh(const std::string& file) {
  const auto mesh = LoadMesh(file);
  const Eigen::Vector3d extent_m = ExtentOf(*mesh);
  FileCheck check{"mesh", std::to_string(mesh->vertices.size()) + " vertices, " +
                              std::to_string(mesh->triangles.size()) + " triangles, " +
                              SizeText(extent_m) + " (x, y, z)"};
  if (const std::string doubt = UnitDoubt(extent_m); !doubt.empty()) check.warnings = {doubt};
  return check;
}

UrdfOptions OptionsOf(const CheckOptions& options) {
  return {.meshes = nullptr, .packages = options.packages, .expand_xacro = true};
}

/// Links that a joint moves and that have no mass, with what is welded to them.
void WarnOfMassless(const UrdfModel& model, std::vector<std::string>& warnings) {
  const UrdfModel welded = WeldFixedLinks(model);
  for (const UrdfJoint& joint : welded.joints) {
    if (welded.Link(joint.child).mass_kg > 0.0) continue;
    warnings.push_back(welded.PlaceOf(joint.child) + ": it has no mass, and the " + joint.type +
                       " joint '" + joint.name + "' moves it: a run refuses such a link");
  }
}

/// Warnings of what the reader takes and a user may not mean.
std::vector<std::string> WarningsOf(const UrdfModel& model) {
  std::vector<std::string> warnings = model.warnings;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    for (const Visual& visual : model.links[i].visuals) {
      const std::string doubt = UnitDoubt(ExtentOf(*visual.mesh));
      if (!doubt.empty()) warnings.push_back(model.place[i] + ": visual: " + doubt);
    }
  }
  WarnOfMassless(model, warnings);
  for (const char* ignored : {"joint_properties", "surface", "contact", "contact_coefficients"}) {
    if (model.left_out.count(ignored) == 0) continue;
    warnings.push_back("<" + std::string(ignored) +
                       "> is left out: friction and damping come from the robot's YAML file");
  }
  return warnings;
}

FileCheck CheckUrdf(const std::string& file, const CheckOptions& options) {
  const UrdfModel model = LoadUrdf(file, OptionsOf(options));
  double mass_kg = 0.0;
  for (const LinkModel& link : model.links) mass_kg += link.mass_kg;
  std::string summary = model.name + ": " + std::to_string(model.links.size()) + " links, " +
                        std::to_string(model.joints.size()) + " joints, " + NumberText(mass_kg) +
                        " kg";
  std::string welded;
  for (const LinkModel& link : model.links) {
    const std::string carrier = CarrierOf(model, link.name);
    if (carrier == link.name) continue;
    welded += (welded.empty() ? "; welded: " : ", ") + link.name + " into " + carrier;
  }
  std::string left_out;
  for (const auto& [element, count] : model.left_out) {
    left_out +=
        (left_out.empty() ? "; left out: " : ", ") + std::to_string(count) + " <" + element + ">";
  }
  return {"urdf",
          summary + welded + left_out +
              "; a run takes it only through a robot's or target's YAML file, with the links and "
              "joints of that system",
          WarningsOf(model), model.left_out};
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

FileCheck CheckRover(const std::string& file, bool is_built) {
  const RoverPlan rover = LoadRoverPlan(file);
  const auto steered =
      std::count_if(rover.wheels.begin(), rover.wheels.end(),
                    [](const WheelPlan& wheel) { return wheel.steer_limit_rad > 0.0; });
  std::string found = rover.name + ": " + std::to_string(rover.wheels.size()) + " wheels, " +
                      std::to_string(steered) + " of them steered";
  if (is_built)
    found += ", " + NumberText(std::round(100.0 * LoadRover(file).mass_kg()) / 100.0) + " kg";
  return {"rover on wheels", found};
}

FileCheck CheckObstacles(const std::string& file) {
  const Obstacles obstacles = LoadObstacles(file);
  return {"obstacles", std::to_string(obstacles.discs.size()) + " discs, " +
                           std::to_string(obstacles.polygons.size()) + " areas"};
}

FileCheck CheckScenario(const std::string& file, const std::vector<System>& systems) {
  const Scenario scenario = LoadScenario(file, {}, KnownSystems(systems));
  const std::string found = FindSystem(systems, scenario.system).check(scenario);
  return {"scenario", scenario.name + ": " + found + ", controller " + scenario.controller};
}

FileCheck CheckCampaign(const std::string& file, const std::vector<System>& systems) {
  const Campaign campaign = LoadCampaign(file, {}, CampaignSystemsOf(systems));
  CheckRuns(campaign, KnownSystems(systems), [&](const Scenario& scenario) {
    FindSystem(systems, scenario.system).check(scenario);
  });
  std::string labels;
  for (const std::string& label : campaign.labels) labels += (labels.empty() ? "" : ", ") + label;
  return {"campaign", campaign.name + ": " + std::to_string(campaign.run_count()) + " runs" +
                          (labels.empty() ? "" : " by " + labels) + "; seed " +
                          std::to_string(campaign.seed.number)};
}

FileCheck CheckReproduction(const std::string& file, const std::vector<System>& systems) {
  const Published published = LoadPublished(file);
  std::vector<CampaignNames> names;
  for (const PublishedCampaign& campaign : published.campaigns) {
    names.push_back(NamesOf(LoadCampaign(campaign.file, {}, CampaignSystemsOf(systems)), systems));
  }
  CheckPublished(published, names);
  return {"published experiment", published.name + ": " + std::to_string(published.rows.size()) +
                                      " rows, " + std::to_string(published.judged.size()) +
                                      " of them judged beside the total"};
}

FileCheck CheckTable(const std::string& file) {
  const TableCheck table = CheckRunTable(file);
  const auto list = [](const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
  };
  return {"campaign table", std::to_string(table.runs) + " runs; checked: " + list(table.checked) +
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
    if (!system.check_file) continue;
    if (const std::optional<FileCheck> check = system.check_file(file)) return *check;
  }
  if (has("left") || has("right")) return CheckRig(file);
  if (has("model")) return CheckCameras(file);
  if (model.Find("k_phi") || model.Find("cohesion_pa") || model.Find("friction_angle_deg")) {
    return CheckSoil(file);
  }
  if (has("radius_m") || has("width_m") || has("paddles")) return CheckWheel(file);
  throw ConfigError(root.place.Text() +
                    ": expected the keys of a scenario, campaign, published experiment, board, "
                    "soil, wheel, camera, rig, rover on wheels, obstacles "
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
  if (IsUrdfFile(file)) return CheckUrdf(file, options);
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
  if (IsUrdfFile(file)) return FindUrdfFaults(file, OptionsOf(options));
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
