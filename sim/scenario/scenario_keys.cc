#include "sim/scenario/scenario_keys.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/other_kind.h"
#include "models/read/text_file.h"
#include "sim/scenario/camera_keys.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/patch_keys.h"
#include "sim/scenario/rock_keys.h"
#include "sim/scenario/scenery_keys.h"
#include "sim/scenario/short_forms.h"
#include "sim/scenario/sun_keys.h"

namespace dockyard {
namespace {

constexpr double kMaxCells = 4e6;
constexpr const char* kCommand = "command";

void VisitController(Keys& keys, Scenario& s, const KnownSystem* system) {
  static const std::vector<std::string> none;
  const std::vector<std::string>& words = system == nullptr ? none : system->controllers;
  if (s.controller.empty() && !words.empty()) s.controller = words.front();
  if (system != nullptr) {
    for (const FormerName& each : system->former_controllers) {
      keys.RefusedWord("controller", each.former, "'" + each.now + "', as it is called now");
    }
  }
  keys.WordOrMapping(
      {"controller", "", "a controller of the system, or a program"}, s.controller, words, kCommand,
      [&](Keys& in) {
        in.Texts({"command", "", "the program's name and arguments", Presence::kRequired},
                 s.command, 64);
        in.Text(
            {"folder", "", "where the program runs, else the file's own folder", Presence::kUnset},
            s.command_folder);
        in.Texts({"files", "", "files that the program needs, and its command does not name",
                  Presence::kUnset},
                 s.command_files, 1000);
        in.Seed({"seed", "", "of the program's own random draws; the world's has no part in it"},
                s.controller_seed);
      });
}

void VisitHeights(Keys& keys, YardHeights& heights) {
  using enum Presence;
  keys.File({"file", "", "of heights, added to the undulation: .png, .tif or .asc", kUnset},
            heights.file);
  keys.Number({"cell_m", "m", "between its samples; none: as the .asc file says", kUnset},
              heights.cell_m, Between(1e-3, 100.0));
  keys.Number({"scale_m", "m", "height of 1 in the file"}, heights.scale_m, Between(-100.0, 100.0));
  keys.Number({"x_m", "m", "of the file's middle, in the target's frame D"}, heights.X_GM.x,
              Between(-1e4, 1e4));
  keys.Number({"y_m", "m", "the same"}, heights.X_GM.y, Between(-1e4, 1e4));
  keys.Degrees({"turn_deg", "deg", "of its rows, from the target's x axis"}, heights.X_GM.heading,
               Between(-180.0, 180.0));
}

void VisitYard(Keys& keys, YardModel& yard) {
  keys.Number({"length_m", "m", "of the ground, from 1.5 m behind the target"}, yard.length_m,
              Between(4.0, 200.0));
  keys.Number({"width_m", "m", "of the ground, to both sides"}, yard.width_m, Between(4.0, 200.0));
  keys.Number({"cell_m", "m", "of the ground's grid; at most 4 million cells"}, yard.cell_m,
              Between(0.002, 0.2));
  keys.Number({"undulation_rms_m", "m", "rms height of the undulation"}, yard.undulation_rms_m,
              NonNegative(0.2));
  keys.Number({"undulation_wavelength_m", "m", "wavelength of the undulation"},
              yard.undulation_wavelength_m, Between(0.2, 50.0));
  keys.Degrees({"slope_deg", "deg", "of the whole yard, under robot and target"}, yard.slope_rad,
               Between(0.0, 30.0));
  keys.Degrees({"slope_direction_deg", "deg", "the way down, from the way the target faces"},
               yard.downhill_rad, Between(-180.0, 180.0));
  if (!keys.writes() || !yard.heights.file.empty()) {
    keys.Mapping({"heights", "", ""}, [&](Keys& in) { VisitHeights(in, yard.heights); });
  }
  keys.Tree({"patches", "", "parts with a soil of their own: soil, and rectangle, disc or polygon",
             Presence::kUnset},
            yard.given_patches, YamlNode::Kind::kSequence);
}

void VisitSite(Keys& keys, Pose2& X_WG) {
  keys.Number({"x_m", "m", "of the whole yard in the world"}, X_WG.x, Between(-1e6, 1e6));
  keys.Number({"y_m", "m", "of the whole yard in the world"}, X_WG.y, Between(-1e6, 1e6));
  keys.Degrees({"heading_deg", "deg", "of the whole yard in the world"}, X_WG.heading,
               Between(-180.0, 180.0));
}

/// The mapping under the system's own name; one under another system's is refused. Before the
/// system is known all are.
void VisitOfSystem(Keys& keys, Scenario& s, const std::vector<KnownSystem>& systems) {
  const std::string hint = "no keys of another system than '" + s.system + "'";
  for (const KnownSystem& system : systems) {
    if (s.system.empty() || s.system == system.name) {
      keys.Tree({system.name, "", "keys of the system's own", Presence::kUnset}, s.of_system,
                YamlNode::Kind::kMapping);
    } else {
      keys.Refused(system.name, hint);
    }
  }
}

void RefuseFormerKeys(Keys& keys) {
  keys.Refused("rover", "the key 'robot' instead");
  for (const char* of_system : {"station", "vision", "tip_angle_deg", "board_dust"}) {
    keys.Refused(of_system, "it under the key of the system's own name");
  }
}

std::vector<std::string> NamesOf(const std::vector<KnownSystem>& systems) {
  std::vector<std::string> names;
  for (const KnownSystem& system : systems) names.push_back(system.name);
  return names;
}

const KnownSystem* Find(const std::vector<KnownSystem>& systems, const std::string& name) {
  const auto at = std::find_if(systems.begin(), systems.end(),
                               [&](const KnownSystem& system) { return system.name == name; });
  return at == systems.end() ? nullptr : &*at;
}

[[noreturn]] void RefuseValue(const YamlNode& root, const std::string& path,
                              const std::string& expected, std::string found = "") {
  const YamlNode* value = FindPath(root, path);
  const YamlNode& at = value == nullptr ? root : *value;
  if (found.empty() && value != nullptr) found = at.Found();
  throw ConfigError(at.place.Text() + ": " + path + ": expected " + expected +
                    (found.empty() ? "" : ", found " + found));
}

/// "file:line:column: key" of a mapping: where a key in it was given last, else where it stands
/// itself, else the document.
std::string PlaceOf(const YamlNode& root, const std::string& path, const std::string& in_it) {
  const YamlNode* value = FindPath(root, path + "." + in_it);
  if (value == nullptr) value = FindPath(root, path);
  return (value == nullptr ? root : *value).place.Text() + ": " + path;
}

/// Between them the keys must agree.
void CheckTogether(const Scenario& s, const YamlNode& root) {
  const YardModel& yard = s.yard;
  const double cells = yard.length_m * yard.width_m / (yard.cell_m * yard.cell_m);
  if (cells > kMaxCells) {
    RefuseValue(root, "yard", "at most 4 million cells", Fixed(1e-6 * cells, 1) + " million");
  }
  if (yard.heights.file.empty() && FindPath(root, "yard.heights") != nullptr) {
    RefuseValue(root, "yard.heights", "the key 'file' in it", "none");
  }
  if ((s.image_width > 0) != (s.image_height > 0)) {
    RefuseValue(root, "camera", "both width_px and height_px, or neither");
  }
  if (!s.start.IsOnPlane()) return;  // the system checks its own
  constexpr double kMargin_m = 1.0;  // from the yard's border
  const DockingCoords at = s.start.on_plane();
  const double x = at.r * std::cos(at.alpha), y = at.r * std::sin(at.alpha);
  const double x_end = yard.length_m - kYardBehind_m - kMargin_m;
  const double y_end = 0.5 * yard.width_m - kMargin_m;
  const auto rounded = [](double value) { return std::round(1e3 * value) / 1e3; };
  if (x > x_end || std::abs(y) > y_end) {
    RefuseValue(root, "start.r_m",
                "a start inside the yard (x up to " + NumberText(rounded(x_end)) +
                    " m, y up to +-" + NumberText(rounded(y_end)) + " m)");
  }
}

/// What a system cannot draw is refused.
void CheckFaults(const Scenario& s, const KnownSystem& system, const YamlNode& root) {
  if (system.spoiled_pictures) return;
  const auto check = [&](const char* path, const EyeFaults& eye) {
    if (!Spoils(eye)) return;
    RefuseValue(root, path, "no such faults, as the system " + system.name + " draws none");
  };
  check("camera.left", s.camera_faults.left);
  check("camera.right", s.camera_faults.right);
}

/// The folder in which the scenario's program runs, absolute: the folder named beside its file,
/// else the file's own. A folder from an option stays as it is.
std::string CommandFolder(const YamlNode& root, const std::string& named) {
  const char* key = named.empty() ? "controller.command" : "controller.folder";
  const YamlPlace& place = FindPath(root, key)->place;
  const std::filesystem::path written = named.empty() ? "." : named;
  const std::filesystem::path folder =
      place.from_option() ? written : ResolveBeside(*place.source, written.string());
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    throw ConfigError(place.Text() + ": controller.folder: expected a folder, found none at '" +
                      folder.string() + "'");
  }
  return AbsolutePath(folder.string());
}

/// A campaign copies them with its results, so that its runs can be made again.
void CheckCommandFiles(const YamlNode& root, const Scenario& scenario) {
  const YamlNode* list = FindPath(root, "controller.files");
  if (list == nullptr) return;
  for (const YamlNode& item : list->items) {
    const std::filesystem::path file = std::filesystem::path(scenario.command_folder) / item.scalar;
    std::error_code error;
    const bool link = std::filesystem::is_symlink(file, error);
    if (std::filesystem::is_regular_file(file, error) && !link) continue;
    throw ConfigError(item.place.Text() + ": controller.files: expected a file, found " +
                      (link ? "a link" : "none") + " at '" + file.string() + "'");
  }
}

/// Dotted keys of a tree of the scenario whose values are files.
void MakeFilesAbsolute(YamlNode& tree, const std::string& path,
                       const std::vector<std::string>& keys) {
  for (const std::string& key : keys) {
    YamlNode* node = FindPath(tree, key);
    if (node == nullptr) continue;
    const std::string name = path + "." + key;
    YamlNode holder;  // a reader needs a mapping
    holder.kind = YamlNode::Kind::kMapping;
    holder.keys.push_back({name, node->place});
    holder.items.push_back(*node);
    node->scalar = AbsolutePath(YamlReader(holder, "", {name}).File(name));
    node->quoted = true;
  }
}

/// A ground or a system of another kind is no key of a scenario: the refusal says where to go on.
void SayWhereToGoOn(const std::function<void()>& read) {
  try {
    read();
  } catch (const ConfigError& error) {
    const std::string text = error.what();
    const auto of = [&](const char* path) { return text.find(path) != text.npos; };
    if (of(": yard.") || of(": rocks.") || of("'yard.") || of("'rocks.")) {
      throw ConfigError(WithOtherKind(text, "ground"));
    }
    throw ConfigError(of(": system: ") ? WithOtherKind(text, "robot") : text);
  }
}

}  // namespace

const std::vector<std::string>& LightWords() {
  static const std::vector<std::string> words{LightName(Light::kEven), LightName(Light::kSpeckled),
                                              LightName(Light::kHardShadow),
                                              LightName(Light::kRoom)};
  return words;
}

void VisitScenario(Keys& keys, Scenario& s, const std::vector<KnownSystem>& systems) {
  using enum Presence;
  keys.Text({"name", "", "shown in results and messages", kRequired}, s.name);
  keys.Word({"system", "", "which kind of robot and target", kRequired}, s.system,
            NamesOf(systems));
  keys.File({"robot", "", "the robot's model", kUnset}, s.robot_file);
  keys.File({"soil", "", "the soil's model", kUnset}, s.soil_file);
  keys.Mapping({"camera", "", ""}, [&](Keys& in) { VisitCamera(in, s); });
  const KnownSystem* system = Find(systems, s.system);
  VisitController(keys, s, system);
  if (system != nullptr && !s.start.HasNames(system->start)) s.start = system->start;
  keys.Mapping({"start", "", "", kRequired}, [&](Keys& in) { s.start.Visit(in); });
  keys.Choice({"light", "", "kind of light"}, s.light, LightWords());
  keys.Mapping({"sun", "", ""}, [&](Keys& in) { VisitSun(in, s.light, s.sun); });
  keys.Mapping({"yard", "", ""}, [&](Keys& in) { VisitYard(in, s.yard); });
  keys.Mapping({"rocks", "", ""}, [&](Keys& in) { VisitRocks(in, s); });
  keys.Tree({"scenery", "", "more that cameras see: solids, meshes and sets of solids", kUnset},
            s.given_scenery, YamlNode::Kind::kSequence);
  keys.Number({"time_limit_s", "s", "simulated time after which the run ends"}, s.time_limit_s,
              Positive(1e5));
  // The physics refuses longer steps.
  keys.Number({"physics_step_s", "s", "of the physics, for convergence studies"}, s.physics_step_s,
              Between(1e-5, 5e-3));
  keys.Seed({"seed", "", "every random draw follows from it"}, s.seed.number);
  keys.Mapping({"site", "", ""}, [&](Keys& in) { VisitSite(in, s.X_WG); });
  keys.Bool({"log_images", "", "keep the images in the run's log"}, s.log_images);
  keys.Number({"log_image_gap_s", "s",
               "least time between images that the log keeps, but at a change of phase; a replay "
               "makes the others"},
              s.log_image_gap_s, Between(0.0, 3600.0));
  keys.Tree({"changes", "", "keys on top of the model files, by model", kUnset}, s.changes,
            YamlNode::Kind::kMapping);
  keys.Tree({"as_built", "", "keys on top of these, which the controller is not told", kUnset},
            s.as_built, YamlNode::Kind::kMapping);
  keys.Tree({"script", "", "open-loop commands in place of a controller", kUnset}, s.script,
            YamlNode::Kind::kSequence);
  VisitOfSystem(keys, s, systems);
  RefuseFormerKeys(keys);
}

Scenario ReadScenario(const YamlNode& written, const std::vector<KnownSystem>& systems) {
  const YamlNode root = WithoutShortForms(written, systems);
  Scenario scenario;
  SayWhereToGoOn(
      [&] { ReadKeys(root, "", [&](Keys& keys) { VisitScenario(keys, scenario, systems); }); });
  if (scenario.of_system.kind == YamlNode::Kind::kNull) scenario.of_system.place = root.place;
  scenario.start_place = PlaceOf(root, "start", scenario.start.numbers().front().name);
  scenario.camera_place = PlaceOf(root, "camera", "width_px");
  scenario.yard_place = PlaceOf(root, "yard", "slope_deg");
  scenario.step_place = PlaceOf(root, "physics_step_s", "");
  scenario.sun_place = PlaceOf(
      root, "sun", scenario.sun.temperature_k > 0.0 ? "temperature_k" : "sky_temperature_k");
  scenario.rocks_place = PlaceOf(root, "rocks", scenario.rocks.cover > 0.0 ? "cover" : "given");
  CheckTogether(scenario, root);
  if (!scenario.command.empty()) {
    scenario.command_folder = CommandFolder(root, scenario.command_folder);
    CheckCommandFiles(root, scenario);
  }
  const KnownSystem& system = *Find(systems, scenario.system);
  CheckFaults(scenario, system, root);
  SayWhereToGoOn([&] { ReadRocks(scenario, root, system); });
  ReadScenery(scenario);
  ReadPatches(scenario.yard);
  MakeFilesAbsolute(scenario.of_system, system.name, system.file_keys);
  MakeFilesAbsolute(scenario.changes, "changes", system.changes_file_keys);
  MakeFilesAbsolute(scenario.as_built, "as_built", system.changes_file_keys);
  return scenario;
}

YamlNode WriteScenario(const Scenario& scenario) {
  Scenario copy = scenario;
  std::vector<KnownSystem> itself{{scenario.system, {scenario.controller}, {}, {}}};
  itself[0].start = scenario.start;
  return WriteKeys([&](Keys& keys) { VisitScenario(keys, copy, itself); });
}

std::vector<std::string> DifferingKeys(const Scenario& a, const Scenario& b) {
  return DifferingKeys(WriteScenario(a), WriteScenario(b));
}

std::string ModelText(const Scenario& scenario) {
  YamlNode tree = WriteScenario(scenario);
  for (const char* key : {"name", "seed", "start"}) RemovePath(tree, key);
  return BlockText(tree);
}

std::vector<KeyRow> ScenarioRows() {
  Scenario scenario;
  const std::vector<KnownSystem> any{{"<system>", {"<controller>"}, {}, {}}};
  std::vector<KeyRow> rows;
  rows = DocumentKeys([&](Keys& keys) { VisitScenario(keys, scenario, any); });
  for (KeyRow& row : rows) {
    if (row.key == "system") row.range = "name of a system";
    if (row.key == "controller") row.default_text = "the system's first";
    if (row.key == "controller") row.range = "name of a controller, or a mapping";
  }
  return rows;
}

}  // namespace dockyard
