#include <algorithm>
#include <set>

#include "models/read/config_error.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

/// A distribution's ends, for all practical purposes: one draw in 10^12 lies beyond each.
constexpr double kEnds[] = {1e-12, 1.0 - 1e-12};

using Check = std::function<void(const Scenario&)>;

/// Whether the key is one of the system's models, whose ranges the system alone knows.
bool IsOfModel(const std::string& key) {
  return PathsOverlap("changes", key) || PathsOverlap("as_built", key);
}

/// Reads a scenario with the key at both ends of its distribution, or at each of its values.
void CheckDispersion(const Dispersion& dispersion, const CampaignRun& run,
                     const std::vector<KnownSystem>& systems, const Check& check) {
  std::vector<YamlNode> values = dispersion.values.values;
  for (const double u : kEnds) {
    if (dispersion.discrete()) break;
    values.push_back(ScalarNode(NumberText(Quantile(dispersion.distribution, u)), false));
    values.back().place = dispersion.key.place;
  }
  for (const YamlNode& value : values) {
    YamlNode tree = WriteScenario(run.scenario);
    PutPath(tree, dispersion.key.name, dispersion.key.place, value);
    const Scenario scenario = ReadScenario(tree, systems);
    if (check && IsOfModel(dispersion.key.name)) check(scenario);
  }
}

}  // namespace

void CheckRuns(const Campaign& campaign, const std::vector<KnownSystem>& systems,
               const Check& check) {
  const RunMaker maker(campaign, systems);
  std::set<std::string> checked;
  const std::int64_t arms = campaign.arm_count();
  for (std::int64_t point = 0; point < campaign.point_count(); ++point) {
    for (std::int64_t arm = 0; arm < arms; ++arm) {
      const CampaignRun run = maker.Make(point * campaign.repeats * arms + arm);
      if (point == 0) {
        for (const Dispersion& each : campaign.dispersions) {
          CheckDispersion(each, run, systems, check);
        }
      }
      if (check && checked.insert(ModelText(run.scenario)).second) check(run.scenario);
    }
  }
}

}  // namespace dockyard
