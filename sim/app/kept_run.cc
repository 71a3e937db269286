#include "sim/app/kept_run.h"

#include "sim/app/commands.h"
#include "sim/app/identity.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/shell_word.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/merge.h"
#include "sim/log/record_files.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

KeptRun RunOfCampaign(const std::filesystem::path& dir, int number, const Invocation& call) {
  const std::vector<System>& systems = call.systems;
  const KeptCampaign kept = OpenKeptCampaign(dir, systems, call.secret_file);
  const std::vector<KnownSystem> known = KnownSystems(systems);
  const RunMaker maker(kept.campaign, known);
  const std::int64_t index = maker.IndexOf(number);
  if (index < 0) {
    throw UsageError(dir.string() + " has no run " + std::to_string(number) + "; it has " +
                     CountText(kept.campaign.run_count(), "run"));
  }
  const Json manifest = ReadManifest(dir);
  const std::string difference =
      ManifestDifference(manifest, MakeManifest(IdentityOf(kept.campaign, known), {}));
  if (!difference.empty()) PrintNote("note: " + dir.string() + ": " + difference);
  KeptRun run{maker.Make(index),
              kept.columns,
              {},
              Folder(dir).In(RunFolder("", number)),
              FolderOfCommands(dir, number)};
  const FinishedRuns finished = ReadShards(dir, RowCheck(kept.campaign), kept.columns);
  const std::size_t place = finished.Find(number);
  if (place < finished.size()) run.result = finished.results[place];
  return run;
}

}  // namespace

ReplayOptions KeptReplayOptions(const std::filesystem::path& dir, const std::string& secret_file) {
  ReplayOptions options;
  const Json manifest = ReadManifest(dir);
  if (manifest.contains(kSealedSha256)) {
    options.secret_file = secret_file.empty() ? "FILE" : secret_file;
  }
  const Json facts = manifest.value("facts", Json::object());
  if (!facts.is_object()) return options;
  const Json limit = facts.value(kAnswerLimitFact, Json());
  if (limit.is_number()) options.commands.answer_limit_s = limit.get<double>();
  options.commands.sandbox = facts.value(kSandboxFact, Json()) == true;
  return options;
}

std::string ReplayCommand(const std::string& program, const std::filesystem::path& dir,
                          const std::string& run, bool starts_program,
                          const ReplayOptions& options) {
  std::string command =
      CommandText(program, {"replay", dir.string()}) + (run.empty() ? "" : " " + run);
  if (!options.secret_file.empty()) command += " --secret " + ShellWord(options.secret_file);
  if (!starts_program) return command;
  for (const std::string& word : OptionWords(options.commands)) command += " " + word;
  return command;
}

KeptRun FindKeptRun(const std::filesystem::path& dir, std::optional<int> number,
                    const std::string& command, const Invocation& call) {
  const std::vector<System>& systems = call.systems;
  const bool campaign = HoldsCampaign(dir);
  if (campaign && !number) {
    throw UsageError(dir.string() + " holds a campaign; name the run, as in: " +
                     CommandText(call.program, {command, dir.string(), "1"}));
  }
  if (!campaign && number && HoldsRun(dir)) {
    throw UsageError(dir.string() + " holds one run; leave out the number");
  }
  if (campaign) return RunOfCampaign(dir, *number, call);
  if (number) RefuseResultsFolder(dir, "the results folder of a campaign");
  if (const auto found = FindRunOfFolder(dir)) {
    return RunOfCampaign(found->campaign, found->run, call);
  }
  if (!HoldsRun(dir)) RefuseResultsFolder(dir, kAnyResults);
  const Scenario scenario =
      LoadScenario((dir / "resolved.yaml").string(), {}, KnownSystems(systems));
  const RowColumns columns = FindSystem(systems, scenario.system).Columns({});
  return {SingleRun(scenario), columns, ReadSingleResult(dir, columns), Folder(dir), Folder(dir)};
}

}  // namespace dockyard
