#include "sim/custom/findings.h"

#include "models/read/config_error.h"
#include "models/read/load_model_yaml.h"
#include "models/read/yaml_reader.h"

namespace dockyard::custom {

void Append(const Findings& more, Findings& findings) {
  findings.faults.insert(findings.faults.end(), more.faults.begin(), more.faults.end());
  findings.doubts.insert(findings.doubts.end(), more.doubts.begin(), more.doubts.end());
}

void RequireNoFault(const Findings& findings) {
  if (!findings.faults.empty()) throw ConfigError(findings.faults.front());
}

Findings FindInDock(const DockModel& dock, const std::string& file) {
  Findings findings = FindHiddenBoards(dock, file);
  Append(FindOutOfReach(dock.tree, dock.electrical, file), findings);
  return findings;
}

Findings FindInRobot(const RobotModel& robot, const std::string& file) {
  Findings findings = FindOutOfReach(robot.tree, robot.electrical, file);
  Append(FindHangingWheels(robot, file), findings);
  return findings;
}

std::string PlaceOfKey(const std::string& file, const std::string& list, std::size_t i,
                       const std::string& key) {
  const YamlNode root = LoadModelYaml(file);
  const std::string path = YamlReader::PathOf(list, i) + "." + key;
  const YamlNode* items = root.Find(list);
  if (items == nullptr || i >= items->items.size()) return file + ": " + path;
  const YamlNode* value = items->items[i].Find(key);
  return (value == nullptr ? items->items[i] : *value).place.Text() + ": " + path;
}

}  // namespace dockyard::custom
