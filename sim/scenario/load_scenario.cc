#include "sim/scenario/load_scenario.h"

#include <filesystem>

#include "sim/scenario/key_path.h"
#include "sim/scenario/other_file_kind.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

void RemoveFolders(YamlNode& node, const std::filesystem::path& dir) {
  for (YamlNode& item : node.items) RemoveFolders(item, dir);
  const std::filesystem::path path = node.scalar;
  if (node.kind != YamlNode::Kind::kScalar || !path.is_absolute()) return;
  const std::filesystem::path inside = path.lexically_relative(dir);
  const bool below = !dir.empty() && !inside.empty() && *inside.begin() != "..";
  node.scalar = (below ? inside : path.filename()).string();
}

}  // namespace

Scenario LoadScenario(const std::string& file, const std::vector<std::string>& overrides,
                      const std::vector<KnownSystem>& systems) {
  YamlNode root = LoadYaml(file);
  for (const std::string& assignment : overrides) SetYaml(root, assignment);
  if (root.Find("campaign") != nullptr) {
    throw OtherFileKind(root.place.Text() + ": expected one scenario, found a campaign", "campaign",
                        file);
  }
  return ReadScenario(root, systems);
}

std::string ResolvedYaml(const Scenario& scenario) { return BlockText(WriteScenario(scenario)); }

std::string YamlWithoutFolders(const Scenario& scenario, const std::string& dir) {
  YamlNode tree = WriteScenario(scenario);
  RemoveFolders(tree, dir.empty() ? dir : AbsolutePath(dir));
  return BlockText(tree);
}

}  // namespace dockyard
