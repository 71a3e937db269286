#include "sim/plant/model_files.h"

#include "models/read/config_error.h"
#include "models/read/yaml_path.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

/// With the file that it stands in, as paths in it are relative to that.
std::string TextOf(const YamlNode& node) {
  return "\n" + (node.place.source ? *node.place.source : "") + "\n" + FlowText(node);
}

void CheckRootsOf(const YamlNode& changes, const std::string& name,
                  const std::vector<std::string>& roots) {
  if (changes.kind == YamlNode::Kind::kNull) return;
  const YamlReader known(changes, name, roots);
  for (const std::string& root : roots) {
    RefuseKey(changes, name, root + ".spreads", "none; spreads are read from the model's own file");
  }
}

}  // namespace

std::string ModelKey(const Scenario& scenario) {
  return scenario.robot_file + "\n" + scenario.soil_file + "\n" + scenario.camera_file + "\n" +
         std::to_string(scenario.image_width) + "x" + std::to_string(scenario.image_height) +
         TextOf(scenario.of_system) + TextOf(scenario.changes) + TextOf(scenario.as_built);
}

void RequireFiles(const Scenario& scenario, const std::string& whose, const std::string& ground) {
  if (scenario.robot_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'robot', " + whose + " file, found none");
  }
  if (scenario.soil_file.empty()) {
    throw ConfigError(scenario.name + ": expected the key 'soil', " + ground + " file, found none");
  }
}

void RefuseCamera(const Scenario& scenario, const std::string& file, const std::string& size) {
  if (!scenario.camera_file.empty()) {
    throw ConfigError(scenario.camera_place + ": expected no camera.file: " + file);
  }
  if (scenario.image_width != 0 || scenario.image_height != 0) {
    throw ConfigError(scenario.camera_place + ": expected no width_px or height_px: " + size);
  }
}

void CheckRoots(const Scenario& scenario, const std::vector<std::string>& roots) {
  CheckRootsOf(scenario.changes, "changes", roots);
  CheckRootsOf(scenario.as_built, "as_built", roots);
}

void RefuseKey(const YamlNode& changes, const std::string& root, const std::string& path,
               const std::string& expected) {
  const YamlNode* value = FindPath(changes, path);
  if (value == nullptr) return;
  throw ConfigError(value->place.Text() + ": " + root + "." + path + ": expected " + expected);
}

}  // namespace dockyard
