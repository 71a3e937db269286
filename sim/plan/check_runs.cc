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

// More than any campaign here: 10 000 runs are checked in 0.2 s, 300 sets of Axel's models in 2 s.
// Without a limit a file of 200 bytes could cost hours.
constexpr std::int64_t kMostRuns = 10000;
constexpr std::size_t kMostModels = 300;
constexpr std::int64_t kMostDraws = 1000;  // of all arms, where they are more than one

/// Calls the system's check for each set of models once, and for no more than kMostModels.
class ModelCheck {
 public:
  explicit ModelCheck(const Check& check) : check_(check) {}
  void operator()(const Scenario& scenario) {
    if (!check_ || checked_.size() == kMostModels) return;
    if (checked_.insert(ModelText(scenario)).second) check_(scenario);
  }

 private:
  const Check& check_;
  std::set<std::string> checked_;
};

/// Reads a scenario with the key at both ends of its distribution, or at each of its values.
void CheckDispersion(const Dispersion& dispersion, const CampaignRun& run,
                     const std::vector<KnownSystem>& systems, ModelCheck& check) {
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
    if (IsOfModel(dispersion.key.name)) check(scenario);
  }
}

/// The points to check: all, or where they are too many each row, each value of the grid and each
/// value changed alone with the first of all others, and every so manieth point.
std::set<std::int64_t> PointsToCheck(const Campaign& campaign, std::int64_t most) {
  const std::int64_t points = campaign.point_count(), stride = (points + most - 1) / most;
  std::set<std::int64_t> chosen;
  for (std::int64_t point = 0; point < points; point += stride) chosen.insert(point);
  if (stride == 1) return chosen;
  const std::int64_t rows = campaign.row_count(), grid = campaign.grid_size();
  for (std::int64_t row = 0; row < rows; ++row) chosen.insert(grid * row);
  std::int64_t step = 1;  // of one factor's values among the points: the first changes fastest
  for (const Factor& factor : campaign.grid) {
    const auto values = static_cast<std::int64_t>(factor.values.size());
    for (std::int64_t value = 0; value < values; ++value) chosen.insert(step * value);
    step *= values;
  }
  for (std::int64_t point = 0; point < points; point += grid * rows) chosen.insert(point);
  return chosen;
}

}  // namespace

void CheckRuns(const Campaign& campaign, const std::vector<KnownSystem>& systems,
               const Check& check) {
  const RunMaker maker(campaign, systems);
  ModelCheck check_models(check);
  const std::int64_t arms = campaign.arm_count();
  const auto draws = static_cast<std::int64_t>(campaign.dispersions.size());
  // Every arm at the first point at least.
  const std::int64_t most = std::max<std::int64_t>(1, kMostRuns / arms);
  const bool all = campaign.point_count() <= most;
  for (const std::int64_t point : PointsToCheck(campaign, most)) {
    for (std::int64_t arm = 0; arm < (all || point == 0 ? arms : 1); ++arm) {
      const CampaignRun run = maker.Make(point * campaign.repeats * arms + arm);
      if (point == 0 && arm * draws <= kMostDraws) {
        for (const Dispersion& each : campaign.dispersions) {
          CheckDispersion(each, run, systems, check_models);
        }
      }
      check_models(run.scenario);
    }
  }
}

}  // namespace dockyard
