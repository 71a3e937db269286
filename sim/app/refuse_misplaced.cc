#include "sim/app/misplaced_file.h"

#include <algorithm>

#include "models/read/config_error.h"
#include "sim/app/check_file.h"

namespace dockyard {
namespace {

bool HasKeyOf(const WantedFile& wanted, const std::string& file) {
  const YamlNode tree = LoadYaml(file);
  return std::any_of(wanted.keys.begin(), wanted.keys.end(),
                     [&](const std::string& key) { return tree.Find(key) != nullptr; });
}

/// Empty for a file of the wanted kind, and for one that is good as nothing.
std::string OtherKindOf(const std::string& file, const WantedFile& wanted,
                        const std::vector<System>& systems) {
  try {
    if (HasKeyOf(wanted, file)) return "";
  } catch (const ConfigError&) {  // no YAML: it may be another file
  }
  try {
    const std::string kind = CheckFile(file, systems).kind;
    return kind == wanted.kind ? "" : kind;
  } catch (const ConfigError&) {
    return "";
  }
}

}  // namespace

const WantedFile kWantedScenario{"scenario",
                                 {"system", "start"},
                                 "the keys name, system and start (docs/reference/scenarios.md)"};
const WantedFile kWantedCampaign{
    "campaign",
    {"campaign", "study", "runs", "table"},
    "the key campaign, a base, and what its runs vary (docs/reference/campaigns.md)"};

void RefuseMisplaced(const std::string& file, const WantedFile& wanted,
                     const std::vector<System>& systems) {
  const std::string found = OtherKindOf(file, wanted, systems);
  if (found.empty()) return;
  throw ConfigError(file + ": expected a " + wanted.kind + ", found a file of the kind '" + found +
                    "'; a " + wanted.kind + " has " + wanted.made_of);
}

}  // namespace dockyard
