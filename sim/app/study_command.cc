#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/number_option.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/run/loop.h"
#include "sim/scenario/study.h"
#include "sim/study/run_study.h"

namespace dockyard {
namespace {

struct StudyArguments {
  std::string file;
  int jobs = 0;  // 0: all processors
  std::string out_dir;
  std::vector<std::string> overrides;
  double run_limit_s = 300.0;
  bool quiet = false;
  CommandOptions commands;
};

constexpr const char* kHelp =
    R"(Run one scenario over ranges of its keys, or with one key changed at a time.

Examples:
  dockyard study {study}
  dockyard study {study} --set repeats=1 --jobs 2 --out out/quick
  dockyard study {study} --set 'vary={start.alpha_deg: [0, 3]}' --out out/two

Any key of a scenario can be varied, those of its models too:
changes.station.cone.funnel_friction. The folder gets runs.csv, points.csv, table.md, curves.svg
and bars.svg. Exit code 10: runs are missing or crashed.)";

void WriteResults(const std::filesystem::path& dir, const Study& study, const RowColumns& columns,
                  const std::vector<StudyRow>& rows) {
  WriteWhole(dir / "runs.csv", StudyRunsCsv(study, columns, rows));
  WriteWhole(dir / "points.csv", StudyPointsCsv(study, columns, rows));
  WriteWhole(dir / "table.md", StudyTable(study, columns, rows));
  const std::string curves = StudyCurves(study, columns, rows),
                    bars = StudyBars(study, columns, rows);
  if (!curves.empty()) WriteWhole(dir / "curves.svg", curves);
  if (!bars.empty()) WriteWhole(dir / "bars.svg", bars);
}

/// The folder may be new, empty, or an earlier study's.
void PrepareFolder(const std::filesystem::path& dir) {
  MakeFolder(dir);
  const bool ours = std::filesystem::exists(dir / "points.csv");
  if (!ours && !std::filesystem::is_empty(dir)) {
    throw UsageError(dir.string() + " is not empty and holds no study; choose another --out");
  }
}

int RunTheStudy(const StudyArguments& arguments, const std::vector<System>& systems) {
  const Study study = LoadStudy(arguments.file, arguments.overrides, StudySystemsOf(systems));
  const System& system = FindSystem(systems, study.points.front().scenario.system);
  const RowColumns columns = system.Columns({});
  StudyOptions options;
  options.out_dir = arguments.out_dir.empty() ? "results/" + study.name : arguments.out_dir;
  options.jobs = arguments.jobs > 0 ? arguments.jobs : UsableProcessors();
  options.run_time_limit_s = arguments.run_limit_s;
  RunOptions run_options;
  arguments.commands.Fill(run_options);
  for (const StudyPoint& point : study.points) RequireAllowed(point.scenario, run_options);
  PrepareFolder(options.out_dir);
  int told_percent = 0;
  options.progress = [&](int done, int total) {
    const int percent = 100 * done / total / 5 * 5;
    if (arguments.quiet || percent == told_percent) return;
    told_percent = percent;
    std::fprintf(stderr, "%d/%d runs done\n", done, total);
  };
  const auto simulate = [&](const CampaignRun& run) {
    return Simulate(FindSystem(systems, run.scenario.system), run, run_options);
  };
  const StudyEnd end = RunStudy(study, simulate, columns, options);
  WriteResults(options.out_dir, study, columns, end.rows);
  std::printf("%s", StudyTable(study, columns, end.rows).c_str());
  PrintNote(std::to_string(end.rows.size()) + " of " + std::to_string(end.total) + " runs in " +
            options.out_dir.string());
  if (end.signal != 0) return kExitSignal + end.signal;
  return end.complete() && !end.any_crashed() ? kExitDone : kExitIncomplete;
}

}  // namespace

void AddStudyCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", kHelp);
  command->add_option("STUDY", arguments->file, "a study file")->required();
  command->add_option("--jobs", arguments->jobs, "processes; all processors if not given")
      ->check(CLI::Range(1, 1024));
  command->add_option("--out", arguments->out_dir, "results folder; results/NAME if not given");
  AddSetOption(*command, arguments->overrides);
  command->add_option("--run-limit", arguments->run_limit_s, "wall time of one run [s]")
      ->check(NumberWithin(1.0, 1e6));
  command->add_flag("--quiet", arguments->quiet, "no progress");
  AddCommandOptions(*command, arguments->commands);
  command->callback(
      [arguments, &systems, &exit_code] { exit_code = RunTheStudy(*arguments, systems); });
}

}  // namespace dockyard
