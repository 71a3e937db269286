#include "sim/scenario/load_scenario.h"

#include "sim/scenario/key_path.h"
#include "sim/scenario/other_file_kind.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {

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

}  // namespace dockyard
