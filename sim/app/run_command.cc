#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/kept_run.h"
#include "sim/app/number_option.h"
#include "sim/app/passing_folder.h"
#include "sim/app/report_content.h"
#include "sim/app/report_option.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/run_work.h"
#include "sim/log/record_files.h"
#include "sim/report/run_table.h"
#include "sim/run/loop.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

struct RunArguments {
  ScenarioOptions scenario;
  CommandOptions commands;
  std::string out_dir;
  ReportOption report;
  double run_limit_s = 0.0;  // 0: none
  bool json = false;
};

constexpr const char* kRunHelp = R"(Simulate one run.

Examples:
  dockyard run {scenario}
  dockyard run {scenario} --seed 7 --set start.r_m=5 --set start.alpha_deg=-20
  dockyard run {scenario} --out out/typical --json
  dockyard run {scenario} --report out/typical.html

Prints the result as a table on stdout, its last line a sentence; --json has every digit. Exit code
0: a success, 4: it ran but did not succeed, 10: --run-limit stopped it. With --out the folder
gets the log and the history of the run, and `dockyard replay` runs it again. With --report a page
shows it, with its replay.)";

/// The folder may be new, empty, or an earlier run's; nothing else is written over.
void PrepareFolder(const std::filesystem::path& dir, const Scenario& scenario) {
  MakeFolder(dir);
  const bool ours = HoldsRun(dir) && !HoldsCampaign(dir);
  if (!ours && !std::filesystem::is_empty(dir)) {
    throw UsageError(dir.string() + " is not empty and holds no single run; choose another --out");
  }
  WriteWhole(dir / "resolved.yaml", ResolvedYaml(scenario));
}

void PrintJson(const RunRecord& record, const std::vector<std::string>& warnings) {
  Json json = OutcomeJson(record);
  json["cpu_time_s"] = record.timing.cpu_time_s;
  if (StartsProgram(record.result)) {
    json["controller_cpu_s"] = record.timing.controller_cpu_s;
    json["controller_wall_s"] = record.timing.controller_wall_s;
  }
  json["warnings"] = warnings;
  std::printf("%s\n", json.dump(1).c_str());
}

/// @param log_dir  holds the run's log
/// @param replay_command  to be pasted; empty: the log does not stay
void WriteReport(const std::filesystem::path& file, const std::filesystem::path& log_dir,
                 const System& system, const Scenario& scenario, const RunRecord& record,
                 const std::string& replay_command) {
  ReportSource source;
  ReportContent content =
      ContentOfRun(log_dir, system, scenario, record.result, replay_command, source);
  content.watched.front().messages = record.messages;
  if (file.has_parent_path()) MakeFolder(file.parent_path());
  WriteWhole(file, ReportPage(content));
  PrintNote("report in " + file.string());
}

void WarnOfDoubts(const System& system, const Scenario& scenario, Invocation& call) {
  if (!system.doubts) return;
  for (const std::string& text : system.doubts(scenario)) Warn(text, &call.warnings);
}

int Run(const RunArguments& arguments, Invocation& call) {
  const CampaignRun run = SingleRun(Load(arguments.scenario, call.systems));
  const System& system = FindSystem(call.systems, run.scenario.system);
  const std::filesystem::path report = arguments.report.FileIn(arguments.out_dir);
  RunOptions options;
  options.log_dir = arguments.out_dir;
  std::optional<PassingFolder> passing;
  if (arguments.out_dir.empty() && !report.empty()) options.log_dir = passing.emplace().path();
  arguments.commands.Fill(options);
  options.run_limit_s = arguments.run_limit_s;
  options.results_dir = options.log_dir;
  RequireAllowed(run.scenario, options);
  WarnOfDoubts(system, run.scenario, call);
  if (!arguments.out_dir.empty()) PrepareFolder(arguments.out_dir, run.scenario);
  const RunRecord record = Simulate(system, run, options);
  if (!arguments.out_dir.empty()) {
    WriteRecordFiles(arguments.out_dir, record);
    WriteSingleResult(arguments.out_dir, record.result, record.columns);
    if (!record.messages.empty()) {
      WriteWhole(std::filesystem::path(arguments.out_dir) / kMessagesFile, record.messages);
    }
    PrintNote("log and history in " + arguments.out_dir);
  }
  if (!report.empty()) {
    const std::string replay =
        passing ? ""
                : ReplayCommand(call.program, options.log_dir, "", StartsProgram(record.result),
                                {.commands = arguments.commands});
    WriteReport(report, options.log_dir, system, run.scenario, record, replay);
  }
  if (!record.messages.empty()) PrintNote("the controller said:\n" + record.messages);
  if (arguments.json) {
    PrintJson(record, call.warnings);
  } else {
    std::printf("%s\n%s\n", RunTable(run.scenario.name, record).c_str(),
                RunSentence(record).c_str());
  }
  if (IsLost(record.result.outcome)) return kExitIncomplete;
  return record.result.success ? kExitDone : kExitNoSuccess;
}

}  // namespace

void AddRunCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", kRunHelp);
  AddScenarioOptions(*command, arguments->scenario);
  AddCommandOptions(*command, arguments->commands);
  command->add_option("--out", arguments->out_dir, "folder for log and history")->type_name("DIR");
  command
      ->add_option("--run-limit", arguments->run_limit_s,
                   "wall time, then the run is stopped [no limit]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.001, 1e6));
  AddReportOption(*command, arguments->report, "--out");
  command->add_flag("--json", arguments->json, "the result as JSON");
  command->callback([arguments, &call] { call.exit_code = Run(*arguments, call); });
}

}  // namespace dockyard
