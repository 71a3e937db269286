#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/identity.h"
#include "sim/app/number_option.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/text.h"
#include "sim/campaign/campaign.h"
#include "sim/log/result_row.h"
#include "sim/plan/make_run.h"
#include "sim/run/loop.h"

namespace dockyard {
namespace {

struct CampaignArguments {
  std::string file;
  int jobs = 0;  // 0: all processors
  std::string out_dir;
  std::vector<std::string> overrides;
  double run_limit_s = 900.0;
  bool quiet = false, dry_run = false;
  CommandOptions commands;
};

constexpr const char* kHelp = R"(Simulate all runs of a campaign on several processors.

Examples:
  dockyard campaign {campaign}
  dockyard campaign {campaign} --jobs 2 --out results/yard
  dockyard campaign {campaign} --dry-run
  dockyard campaign {sweep} --set design.runs=1 --out out/quick
  dockyard campaign {sweep} --set 'vary={start.alpha_deg: [0, 3]}' --set figures= --out out/two

Any key of a scenario can be varied or drawn, those of its models too. Stopped by Ctrl-C or a power cut, the same command goes on where it was. The results are the
same, bit for bit, for any number of jobs. Exit code 10: runs are missing or crashed.)";

constexpr const char* kReproduceHelp = R"(Simulate the runs of a published experiment.

Examples:
  dockyard reproduce

The experiment is a campaign of its system: the options, results and exit codes are those of `campaign`.)";

bool AnyCrashed(const FinishedRuns& runs) {
  for (const auto& [number, run] : runs) {
    if (run.result.outcome == kCrashed) return true;
  }
  return false;
}

/// The text quoted as one word for a shell.
std::string Quoted(const std::string& word) {
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=-";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

std::string CommandToGoOn(const CampaignArguments& arguments, const std::string& out_dir) {
  std::string command = "dockyard campaign " + Quoted(arguments.file) + " --out " + Quoted(out_dir);
  for (const std::string& override : arguments.overrides) command += " --set " + Quoted(override);
  if (arguments.jobs > 0) command += " --jobs " + std::to_string(arguments.jobs);
  if (arguments.commands.allow) command += " --allow-commands";
  if (arguments.commands.answer_limit_s != CommandOptions{}.answer_limit_s) {
    command += " --answer-limit " + NumberText(arguments.commands.answer_limit_s);
  }
  if (arguments.run_limit_s != CampaignArguments{}.run_limit_s) {
    command += " --run-limit " + NumberText(arguments.run_limit_s);
  }
  return command;
}

/// Every mistake is found before a run. The workers, which are forked, share the loaded models.
/// Returns the first run.
CampaignRun CheckAll(const Campaign& campaign, const RunOptions& options,
                     const std::vector<System>& systems) {
  const std::vector<KnownSystem> known = KnownSystems(systems);
  CheckRuns(campaign, known, [&](const Scenario& scenario) {
    RequireAllowed(scenario, options);
    FindSystem(systems, scenario.system).check(scenario);
  });
  return RunMaker(campaign, known).Make(0);
}

int RunCampaignCommand(const CampaignArguments& arguments, const std::vector<System>& systems) {
  const Campaign campaign =
      LoadCampaign(arguments.file, arguments.overrides, CampaignSystemsOf(systems));
  RunOptions of_run{.log_dir = {}, .labels = campaign.labels};
  arguments.commands.Fill(of_run);
  if (arguments.dry_run) {
    std::printf("%s", PlanCsv(campaign, KnownSystems(systems)).c_str());
    return kExitDone;
  }
  const CampaignRun first = CheckAll(campaign, of_run, systems);
  const System& system = FindSystem(systems, first.scenario.system);
  CampaignOptions options;
  options.systems = KnownSystems(systems);
  options.out_dir =
      arguments.out_dir.empty() ? "results/" + campaign.name : std::string(arguments.out_dir);
  options.jobs = arguments.jobs > 0 ? arguments.jobs : UsableProcessors();
  options.run_time_limit_s = arguments.run_limit_s;
  options.progress = arguments.quiet ? ProgressStyle::kNone : ProgressStyleOfStderr();
  options.identity = IdentityText(campaign, options.systems);
  options.columns = system.Columns(campaign.labels);
  options.draw = system.draw;
  options.draw_campaign = system.draw_campaign;
  const RunFunction run = [&](const CampaignRun& what, const std::filesystem::path& log_dir) {
    RunOptions logged = of_run;
    logged.log_dir = log_dir;
    return Simulate(system, what, logged);
  };
  const CampaignEnd end = RunCampaign(campaign, run, options);
  if (end.signal != 0) {
    PrintNote("stopped: " + std::to_string(end.runs.size()) + " of " + std::to_string(end.total) +
              " runs are kept in " + options.out_dir.string() +
              "\nto go on: " + CommandToGoOn(arguments, options.out_dir.string()));
    return kExitSignal + end.signal;
  }
  std::printf("%s", end.summary.c_str());
  PrintNote("results and plots in " + options.out_dir.string());
  return end.complete() && !AnyCrashed(end.runs) ? kExitDone : kExitIncomplete;
}

void AddOptions(CLI::App& command, CampaignArguments& arguments) {
  command.add_option("--jobs", arguments.jobs, "processes at once [all processors]")
      ->check(CLI::Range(1, 1024));
  command.add_option("--out", arguments.out_dir, "results folder [results/<name>]");
  AddSetOption(command, arguments.overrides);
  AddCommandOptions(command, arguments.commands);
  command.add_option("--run-limit", arguments.run_limit_s, "wall time of one run [900 s]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.001, 1e6));
  command.add_flag("--quiet", arguments.quiet, "no progress on stderr");
  command.add_flag("--dry-run", arguments.dry_run,
                   "print the runs as CSV, which can be a campaign's table, and run none");
}

/// Without a name: lists all.
int Reproduce(const std::string& name, CampaignArguments arguments,
              const std::vector<System>& systems) {
  std::string names;
  for (const System& system : systems) {
    for (const Reproduction& each : system.reproductions) {
      if (name.empty()) std::printf("%s: %s\n", each.name.c_str(), each.meaning.c_str());
      names += (names.empty() ? "" : ", ") + each.name;
      if (name != each.name) continue;
      PrintNote(each.meaning);
      arguments.file = each.campaign_file;
      return RunCampaignCommand(arguments, systems);
    }
  }
  if (name.empty()) return kExitDone;
  throw UsageError("NAME: expected one of " + names + ", found '" + name + "'");
}

}  // namespace

void AddReproduceCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<CampaignArguments>();
  auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("reproduce", kReproduceHelp);
  command->add_option("NAME", *name, "the experiment; without it, all are listed");
  AddOptions(*command, *arguments);
  command->callback([arguments, name, &systems, &exit_code] {
    exit_code = Reproduce(*name, *arguments, systems);
  });
}

void AddCampaignCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<CampaignArguments>();
  CLI::App* command = app.add_subcommand("campaign", kHelp);
  command->add_option("FILE", arguments->file, "a campaign file")->required();
  AddOptions(*command, *arguments);
  command->callback(
      [arguments, &systems, &exit_code] { exit_code = RunCampaignCommand(*arguments, systems); });
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
