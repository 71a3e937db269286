#include "sim/app/kept_campaign.h"

#include <algorithm>

#include "sim/app/commands.h"
#include "sim/app/scenario_options.h"
#include "sim/plan/make_run.h"
#include "sim/report/points.h"

namespace dockyard {

KeptCampaign ReadKeptCampaign(const std::filesystem::path& dir,
                              const std::vector<System>& systems) {
  const std::filesystem::path file = dir / "resolved.yaml";
  if (!std::filesystem::exists(dir / "results.csv") || !std::filesystem::exists(file)) {
    throw UsageError("DIR: expected the results folder of a campaign, found none in '" +
                     dir.string() + "'");
  }
  KeptCampaign kept;
  kept.campaign = LoadCampaign(file.string(), {}, CampaignSystemsOf(systems));
  const std::vector<KnownSystem> known = KnownSystems(systems);
  const std::string system = RunMaker(kept.campaign, known).Make(0).scenario.system;
  kept.columns = FindSystem(systems, system).Columns(kept.campaign.labels);
  kept.runs = ReadResults(dir, kept.columns);
  return kept;
}

void RequireArm(const KeptCampaign& kept, const std::string& arm) {
  std::string names;
  for (const Arm& each : kept.campaign.arms) {
    if (each.name == arm) return;
    names += (names.empty() ? "" : ", ") + each.name;
  }
  throw UsageError("expected an arm of the campaign (" + (names.empty() ? "it has none" : names) +
                   "), found '" + arm + "'");
}

std::vector<const RunResult*> RunsOfArm(const KeptCampaign& kept, const std::string& arm) {
  std::vector<const RunResult*> rows;
  for (const auto& [number, run] : kept.runs) {
    if (arm.empty() || LabelOf(run.result, kept.columns, "arm") == arm) {
      rows.push_back(&run.result);
    }
  }
  return rows;
}

}  // namespace dockyard
