#include "sim/app/kept_campaign.h"

#include "models/read/near_names.h"
#include "sim/app/commands.h"
#include "sim/app/scenario_options.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/merge.h"
#include "sim/plan/file_keys.h"
#include "sim/plan/make_run.h"
#include "sim/report/points.h"

namespace dockyard {

void RefuseResultsFolder(const std::filesystem::path& dir, const std::string& expected) {
  std::error_code ignored;
  const bool there = std::filesystem::exists(dir, ignored);
  const bool folder = std::filesystem::is_directory(dir, ignored);
  throw UsageError("DIR: expected " + expected + ", found " +
                   (folder  ? "no results in '"
                    : there ? "the file '"
                            : "no folder '") +
                   dir.string() + "'" + DidYouMeanFile(dir));
}

KeptCampaign OpenKeptCampaign(const std::filesystem::path& dir,
                              const std::vector<System>& systems) {
  if (!HoldsCampaign(dir)) RefuseResultsFolder(dir, "the results folder of a campaign");
  KeptCampaign kept;
  kept.campaign = WithAbsolutePaths(
      LoadCampaign((dir / "campaign.yaml").string(), {}, CampaignSystemsOf(systems)),
      KnownSystems(systems));
  kept.system = RunMaker(kept.campaign, KnownSystems(systems)).Make(0).scenario.system;
  kept.columns = FindSystem(systems, kept.system).Columns(kept.campaign.labels);
  return kept;
}

KeptCampaign ReadKeptCampaign(const std::filesystem::path& dir,
                              const std::vector<System>& systems) {
  KeptCampaign kept = OpenKeptCampaign(dir, systems);
  kept.runs = ReadShards(dir, kept.columns);
  LeaveOutUncounted(dir, kept.runs);
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
  for (const RunResult& result : kept.runs.results) {
    if (arm.empty() || LabelOf(result, kept.columns, "arm") == arm) rows.push_back(&result);
  }
  return rows;
}

}  // namespace dockyard
