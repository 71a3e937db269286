#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/app/campaign_end.h"
#include "sim/app/campaign_setup.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/identity.h"
#include "sim/app/judging.h"
#include "sim/app/report_content.h"
#include "sim/app/report_option.h"
#include "sim/app/terminal.h"
#include "sim/app/until_accepted_options.h"
#include "sim/app/watch.h"
#include "sim/base/count_text.h"
#include "sim/base/shell_word.h"
#include "sim/campaign/campaign.h"
#include "sim/plan/make_run.h"

namespace dockyard {
namespace {

struct CommandArguments {
  CampaignArguments campaign;
  int jobs = 0;  // 0: all processors
  std::string shard, watch_dir;
  bool quiet = false, dry_run = false, json = false;
  ReportOption report;
  JudgingOptions judging;
  UntilAcceptedOptions until;
};

constexpr const char* kCampaignHelp = R"(Simulate all runs of a campaign on several processors.

Examples:
  dockyard campaign {campaign}
  dockyard campaign {campaign} --jobs 2 --out results/yard --report
  dockyard campaign {campaign} --dry-run
  dockyard campaign {sweep} --set design.runs=1 --out out/quick
  dockyard campaign {sweep} --set design.runs=1 --out out/quick \
    --require 'success >= 0'
  dockyard campaign {sweep} --set 'vary={start.alpha_deg: [0, 3]}' \
    --set figures= --out out/two

Any key of a scenario can be varied or drawn, those of its models too. Stopped by Ctrl-C, a crash
or a power cut, the same command goes on where it was. The results are the same, bit for bit, for
any number of jobs and shards. Exit code 10: runs are missing, crashed or were stopped; 22: a
requirement is not met. With --until-accepted 0: accepted, 20: not accepted, 21: undecided.)";

std::string CommandToGoOn(const CommandArguments& arguments, const std::string& out_dir,
                          const Invocation& call) {
  std::string command =
      CommandText(call.program, {"campaign", arguments.campaign.file, "--out", out_dir});
  for (const std::string& word : OptionWords(arguments.campaign)) command += " " + ShellWord(word);
  if (arguments.jobs > 0) command += " --jobs " + std::to_string(arguments.jobs);
  if (!arguments.shard.empty()) command += " --shard " + arguments.shard;
  return command + WordsOf(arguments.until) + WordsOf(arguments.judging) +
         WordsOf(arguments.report);
}

/// Results are judged when all of them are there, and a stopped test leaves no fair shares.
void RequireJudgeable(const CommandArguments& arguments) {
  const bool judges = !WordsOf(arguments.judging).empty();
  if (!arguments.shard.empty() && (judges || arguments.until.asked)) {
    throw UsageError("--shard: expected no --until-accepted, and --require and --junit with merge");
  }
  if (!arguments.shard.empty() && arguments.report.asked) {
    throw UsageError("--shard: expected no --report; dockyard report makes it after the merge");
  }
  if (arguments.until.asked &&
      (arguments.campaign.retry_lost || !arguments.judging.require.empty())) {
    throw UsageError("--until-accepted: expected no --require and no --retry-crashed");
  }
}

ProgressStyle StyleOf(const CommandArguments& arguments) {
  if (arguments.json) return ProgressStyle::kJson;
  return arguments.quiet ? ProgressStyle::kNone : ProgressStyleOfStderr();
}

int EndOfShard(const CommandArguments& arguments, const CampaignOptions& options,
               const ShardEnd& end, const Invocation& call) {
  const std::string dir = options.out_dir.string();
  if (end.signal != 0) {
    PrintNote("stopped: " + std::to_string(end.tally.done) + " of " +
              CountText(end.total, "run is", "runs are") + " kept in " + dir +
              "\nto go on: " + CommandToGoOn(arguments, dir, call));
    return kExitSignal + end.signal;
  }
  PrintNote("shard " + arguments.shard + ": " +
            TallyText(end.tally, end.total, SuccessWord(options.columns)) +
            "\nwhen all shards are done: " + CommandText(call.program, {"merge", dir}));
  return end.complete() && end.tally.lost == 0 ? kExitDone : kExitIncomplete;
}

/// The exit code of what the second simulations came to.
int WarnOfNotRepeated(const ShardEnd& end, Invocation& call) {
  int code = kExitDone;
  for (const NotRepeated& each : end.not_repeated) {
    std::string text = "run " + std::to_string(each.run) + ", simulated again for its log, ";
    if (each.cells.empty()) {
      Warn(text + "was lost: it has no log; the same command makes it up", &call.warnings);
      if (code == kExitDone) code = kExitIncomplete;
      continue;
    }
    for (std::size_t i = 0; i < each.cells.size(); ++i) {
      const DifferingCell& cell = each.cells[i];
      text += (i == 0 ? "differs: " : ", ") + cell.column + " was " + cell.was + ", is " + cell.is;
    }
    Warn(text + "; its log is not of its row", &call.warnings);
    code = kExitOurBug;
  }
  return code;
}

int RunCampaignCommand(const CommandArguments& arguments, Invocation& call) {
  const std::vector<System>& systems = call.systems;
  if (!arguments.watch_dir.empty()) {
    return WatchCampaign(arguments.watch_dir, arguments.json, call);
  }
  if (arguments.campaign.file.empty()) {
    throw UsageError("FILE: expected a campaign file, or --watch DIR");
  }
  Campaign loaded = LoadCampaign(arguments.campaign, systems);
  call.secret_file = arguments.campaign.secret_file;
  if (arguments.dry_run) {
    std::printf("%s", PlanCsv(loaded, KnownSystems(systems)).c_str());
    return kExitDone;
  }
  RequireJudgeable(arguments);
  const std::optional<SequentialPlan> plan = PlanUntilAccepted(arguments.until, loaded);
  auto [campaign, run, options] = MakeReady(std::move(loaded), arguments.campaign, systems);
  const std::vector<Requirement> requirements =
      ReadRequirements(arguments.judging, options.columns, campaign);
  SequentialEnd followed;
  if (plan) options.enough = Follower(options.out_dir, *plan, followed);
  options.shard = ShardOption(arguments.shard);
  options.jobs = arguments.jobs > 0 ? arguments.jobs : UsableProcessors();
  options.progress = StyleOf(arguments);
  for (const std::string& sentence : UnnamedFilesOf(campaign, KnownSystems(systems))) {
    Warn(sentence, &call.warnings);
  }
  const ShardEnd shard = RunShard(campaign, run, options);
  const int repeated = WarnOfNotRepeated(shard, call);
  if (!plan) GoOnPastAcceptance(options.out_dir);
  if (!options.shard.whole()) {
    const int code = EndOfShard(arguments, options, shard, call);
    return shard.signal != 0 || repeated == kExitDone ? code : repeated;
  }
  if (plan) KeepAcceptance(options.out_dir, *plan, followed);
  const CampaignEnd end = MergeShards(options.out_dir, campaign, options.columns);
  if (shard.signal != 0) return EndOfShard(arguments, options, shard, call);
  int code = ReportEnd(end, options.out_dir, arguments.json, call);
  if (plan) code = ReportAcceptance(*plan, followed, arguments.json, call);
  if (arguments.report.asked) {
    WriteReport(options.out_dir, arguments.report.FileIn(options.out_dir), call, requirements);
  }
  code = JudgeResults(arguments.judging, requirements, end, campaign, options.columns,
                      options.out_dir, arguments.json, code, call);
  return repeated == kExitDone ? code : repeated;
}

void AddOptions(CLI::App& command, CommandArguments& arguments) {
  AddCampaignOptions(command, arguments.campaign);
  command.add_option("--jobs", arguments.jobs, "processes at once [all processors]")
      ->check(CLI::Range(1, 1024));
  AddJudgingOptions(command, arguments.judging);
  AddUntilAcceptedOptions(command, arguments.until);
  command.add_option("--shard", arguments.shard, "K/N: every N-th run, from the K-th on");
  AddReportOption(command, arguments.report, "the results folder");
  command.add_flag("--json", arguments.json, "progress and result as JSON, a line each");
  command.add_flag("--quiet", arguments.quiet, "no progress on stderr");
  command.add_flag("--dry-run", arguments.dry_run,
                   "print the runs as CSV, which can be a campaign's table, and run none");
}

}  // namespace

void AddCampaignCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<CommandArguments>();
  CLI::App* command = app.add_subcommand("campaign", kCampaignHelp);
  command->add_option("FILE", arguments->campaign.file, "a campaign file")->type_name("FILE");
  AddOptions(*command, *arguments);
  command
      ->add_option("--watch", arguments->watch_dir,
                   "show the progress of the campaign that runs in this folder")
      ->type_name("DIR");
  command->callback([arguments, &call] { call.exit_code = RunCampaignCommand(*arguments, call); });
}

void AddStudyCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("study", "A study is a campaign: dockyard campaign FILE");
  command->group("")->allow_extras();
  command->callback([] {
    throw UsageError(
        "a study is a campaign: dockyard campaign FILE, with 'campaign' in place of 'study', "
        "'design: {runs: N}' of 'repeats' and 'figures' of 'plot' (docs/reference/campaigns.md)");
  });
}

}  // namespace dockyard
