#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/film_files.h"
#include "sim/app/identity.h"
#include "sim/app/kept_run.h"
#include "sim/app/number_option.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/base/shell_word.h"
#include "sim/bridge/pipe_controller.h"
#include "sim/log/result_row.h"
#include "sim/log/run_log.h"
#include "sim/run/loop.h"
#include "sim/run/replay_log.h"

namespace dockyard {
namespace {

struct ReplayArguments {
  std::string dir;
  std::optional<int> run;  // none: the folder of a single run
  CommandOptions commands;
  std::string frames_dir;  // empty: no pictures
  double period_s = 0.1;
  OutsideArguments outside;
};

constexpr const char* kReplayHelp =
    R"(Run one run again and say whether it came out the same.

Examples:
  dockyard replay results/{campaign_name} 17
  dockyard replay out/typical
  dockyard replay out/typical --frames out/film --period 5
  dockyard replay out/typical --frames out/tip --period 20 --at tip

Compares the result row and state_hash bit for bit, then feeds the logged sensor frames to the
controller alone and compares its commands. Exit code 0: the same, 1: not the same, 10: the
folder holds no result of this run, or its log is cut short.

--frames compares nothing: it draws the run as its log tells it, from outside and with the cameras'
images in the corner, one PNG for each --period of simulated time, and prints the command that makes
a film of them. A run whose log is not kept is simulated again.)";

/// The processors and libraries that a campaign's rows were made on, where they are not these.
void ReportEnvironment(const std::filesystem::path& dir) {
  const Json manifest = Json::parse(ReadWhole(dir / "manifest.json").value_or(""), nullptr,
                                    /*allow_exceptions=*/false);
  if (!manifest.is_object() || !manifest.contains("shards")) return;
  const Json here = EnvironmentJson();
  for (const auto& [shard, header] : manifest["shards"].items()) {
    const Json there = header.is_object() ? header.value("environment", Json()) : Json();
    if (!there.is_object()) continue;
    for (const auto& [name, value] : here.items()) {
      if (name == "program" || there.value(name, "") == value) continue;
      PrintNote("note: shard " + shard + " was made with " + name + " '" + there.value(name, "") +
                "', here it is '" + value.get<std::string>() + "'");
    }
  }
}

/// Columns whose values differ, with both values; true when none does.
bool ReportRow(const RunResult& then, const RunResult& now, const RowColumns& columns) {
  const std::vector<std::string> names = ColumnNames(columns);
  const std::vector<std::string> cells_then = RowCells(then, columns),
                                 cells_now = RowCells(now, columns);
  std::vector<std::size_t> differing;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (cells_then[i] != cells_now[i]) differing.push_back(i);
  }
  if (differing.empty()) {
    std::printf("run %d: same result row, bit for bit (%s)\n", now.run, now.outcome.c_str());
    return true;
  }
  std::printf("run %d: not the same; %zu columns differ\n", now.run, differing.size());
  for (const std::size_t i : differing) {
    std::printf("  %-22s was %s, is %s\n", names[i].c_str(), cells_then[i].c_str(),
                cells_now[i].c_str());
  }
  return false;
}

/// What the controller did, run alone from its log; the exit code where the row is the same.
enum class Alone { kSame = kExitDone, kDiffers = kExitOurBug, kLogIsShort = kExitIncomplete };

/// Throws ControllerFailure where its program fails.
Alone ReportCommands(const std::filesystem::path& run_dir, const Scenario& scenario,
                     const RunOptions& options, const std::vector<System>& systems) {
  RunLogReader log(run_dir);
  const System& system = FindSystem(systems, scenario.system);
  const auto fed = ReplayLog(log, system, scenario, system.make_ready(scenario), options);
  if (!fed) {
    std::printf("controller alone: not run, the models' nominal parameters are not the log's\n");
    return Alone::kDiffers;
  }
  const ControllerReplay& replay = *fed;
  const auto compared = static_cast<unsigned long long>(replay.compared);
  if (replay.differs_at) {
    std::printf("controller alone: other commands at %.3f s, after %llu equal ones\n",
                kTickSeconds * static_cast<double>(*replay.differs_at), compared);
    return Alone::kDiffers;
  }
  if (replay.blind_at) {
    std::printf("controller alone: same for %llu steps, then the log has no images\n", compared);
    return Alone::kSame;
  }
  if (!replay.complete) {
    std::printf("controller alone: same for %llu steps, then the log is cut short\n", compared);
    return Alone::kLogIsShort;
  }
  if (!replay.guarded) {
    PrintNote("note: the log has no check values, so damage to it may go unseen");
  }
  std::printf("controller alone: same commands at all %llu steps\n", compared);
  return Alone::kSame;
}

/// The same; a program that fails must have failed so in the run.
Alone ReportController(const std::filesystem::path& run_dir, const Scenario& scenario,
                       const std::string& outcome, const RunOptions& options,
                       const std::vector<System>& systems) {
  try {
    return ReportCommands(run_dir, scenario, options, systems);
  } catch (const ControllerFailure& failure) {
    const bool same = failure.outcome() == outcome;
    std::printf("controller alone: %s (%s)\n",
                same ? "fails as it did in the run" : "fails, unlike in the run", failure.what());
    return same ? Alone::kSame : Alone::kDiffers;
  }
}

int DrawFrames(const ReplayArguments& arguments, const KeptRun& kept,
               const std::vector<System>& systems) {
  const System& system = FindSystem(systems, kept.run.scenario.system);
  const StageShapes shapes = ShapesToDraw(system, kept.run.scenario);
  const OutsideOptions outside = arguments.outside.options(shapes);
  const bool logged = std::filesystem::exists(kept.log_dir / kRunLogFile);
  RunOptions options{.log_dir = {}, .labels = kept.columns.labels};
  arguments.commands.Fill(options);
  const LoggedRun log =
      logged ? ReadLoggedRun(kept.log_dir) : LogAnew(system, kept.run, std::move(options));
  const std::filesystem::path dir = arguments.frames_dir;
  const int frames = WriteFilm(log, shapes, outside, arguments.period_s, dir);
  PrintNote(std::to_string(frames) + " frames in " + dir.string() + "; a film of them:");
  std::printf("ffmpeg -framerate %s -i %s -pix_fmt yuv420p %s\n",
              NumberText(1.0 / arguments.period_s).c_str(),
              ShellWord((dir / "frame_%05d.png").string()).c_str(),
              ShellWord((dir / "film.mp4").string()).c_str());
  return log.complete ? kExitDone : kExitIncomplete;
}

int Replay(const ReplayArguments& arguments, const std::vector<System>& systems) {
  const KeptRun kept = FindKeptRun(arguments.dir, arguments.run, "replay", systems);
  if (!arguments.frames_dir.empty()) return DrawFrames(arguments, kept, systems);
  if (!kept.result) {
    PrintError("run " + std::to_string(kept.run.run) + " has no result in " + arguments.dir +
               " yet");
    return kExitIncomplete;
  }
  if (IsLost(kept.result->outcome)) {
    PrintError("run " + std::to_string(kept.run.run) + " " + kept.result->outcome +
               ": there is nothing to compare with");
    return kExitIncomplete;
  }
  const System& system = FindSystem(systems, kept.run.scenario.system);
  RunOptions options{.log_dir = {}, .labels = kept.columns.labels};
  arguments.commands.Fill(options);
  const RunRecord now = Simulate(system, kept.run, options);
  const bool same_row = ReportRow(*kept.result, now.result, kept.columns);
  if (!same_row && arguments.run) ReportEnvironment(arguments.dir);
  if (!std::filesystem::exists(kept.log_dir / kRunLogFile)) {
    PrintError("controller alone: not run, there is no log in " + kept.log_dir.string());
    return same_row ? kExitIncomplete : kExitOurBug;
  }
  const Alone alone =
      ReportController(kept.log_dir, kept.run.scenario, now.result.outcome, options, systems);
  return same_row ? static_cast<int>(alone) : kExitOurBug;
}

}  // namespace

void AddReplayCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand("replay", kReplayHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign or of one run")
      ->required();
  command->add_option("RUN", arguments->run, "number of the run in a campaign");
  AddCommandOptions(*command, arguments->commands);
  command->add_option("--frames", arguments->frames_dir, "instead: folder for pictures of the run");
  command->add_option("--period", arguments->period_s, "simulated time from frame to frame [0.1 s]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.1, 60.0));
  AddOutsideOptions(*command, arguments->outside);
  command->callback([arguments, &systems, &exit_code] { exit_code = Replay(*arguments, systems); });
}

}  // namespace dockyard
