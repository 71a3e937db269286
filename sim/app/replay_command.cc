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
#include "sim/app/kept_campaign.h"
#include "sim/app/kept_run.h"
#include "sim/app/number_option.h"
#include "sim/app/passing_folder.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/json.h"
#include "sim/base/shell_word.h"
#include "sim/bridge/pipe_controller.h"
#include "sim/campaign/campaign_folder.h"
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
  bool recorded = false;
  bool json = false;
};

constexpr const char* kReplayHelp =
    R"(Run one run again and say whether it came out the same.

Examples:
  dockyard replay results/{campaign_name} 17
  dockyard replay out/typical
  dockyard replay out/typical --frames out/film --period 5
  dockyard replay out/typical --frames out/near --period 20 --at target

Compares the result row and state_hash bit for bit, then feeds the logged sensor frames to the
controller alone and compares its commands. Where the log keeps some of the images alone
(log_image_gap_s) those of the run made again are fed. Exit code 0: the same, 1: not the same, 10:
the folder holds no result of this run, or its log is cut short.

--frames compares nothing: it draws the run as its log tells it, from outside and with the cameras'
images in the corner, one PNG for each --period of simulated time, and prints the command that makes
a film of them. A run whose log is not kept is simulated again. --at without --from shows its point
from near, from where the least hides it while the robot is there.)";

/// The processors and libraries that a campaign's rows were made on, where they are not these.
void ReportEnvironment(const std::filesystem::path& dir) {
  const Json manifest = ReadManifest(dir);
  if (!manifest.contains("shards")) return;
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

/// What was found: said at once, or printed as JSON at the end.
struct ReplayAnswer {
  bool as_json = false;
  std::vector<std::string>& warnings;
  Json json = Json::object();

  void Say(const std::string& line) const {
    if (!as_json) std::printf("%s\n", line.c_str());
  }
  void Print() {
    if (!as_json) return;
    json["warnings"] = warnings;
    std::printf("%s\n", json.dump(1).c_str());
  }
};

/// Columns whose values differ, with both values; true when none does.
bool ReportRow(const RunResult& then, const RunResult& now, const RowColumns& columns,
               ReplayAnswer& answer) {
  const std::vector<DifferingCell> differing = DifferingCells(then, now, columns);
  const std::string run = "run " + std::to_string(now.run);
  answer.json["run"] = now.run;
  answer.json["outcome"] = now.outcome;
  answer.json["same_row"] = differing.empty();
  answer.json["differing"] = Json::array();
  if (differing.empty()) {
    answer.Say(run + ": same result row, bit for bit (" + now.outcome + ")");
    return true;
  }
  answer.Say(run + ": not the same; " +
             CountText(differing.size(), "column differs", "columns differ"));
  for (const DifferingCell& cell : differing) {
    std::string name = cell.column;
    name.resize(std::max<std::size_t>(name.size(), 22), ' ');
    answer.Say("  " + name + " was " + cell.was + ", is " + cell.is);
    answer.json["differing"].push_back(
        {{"column", cell.column}, {"was", cell.was}, {"is", cell.is}});
  }
  return false;
}

/// What the controller did, run alone from its log; the exit code where the row is the same.
enum class Alone { kSame = kExitDone, kDiffers = kExitOurBug, kLogIsShort = kExitIncomplete };

Alone Conclude(Alone alone, const std::string& what, ReplayAnswer& answer) {
  answer.Say("controller alone: " + what);
  answer.json["controller_alone"] = {{"same", alone != Alone::kDiffers}, {"text", what}};
  return alone;
}

/// Throws ControllerFailure where its program fails.
Alone ReportCommands(const Folder& run_dir, const CampaignRun& run, const RunOptions& options,
                     const std::vector<System>& systems, ReplayAnswer& answer) {
  RunLogReader log(run_dir);
  const System& system = FindSystem(systems, run.scenario.system);
  const auto fed = ReplayLog(log, system, run, system.make_ready(run.scenario), options);
  if (!fed) {
    return Conclude(Alone::kDiffers, "not run, the models' nominal parameters are not the log's",
                    answer);
  }
  const ControllerReplay& replay = *fed;
  const std::string steps = CountText(replay.compared, "step");
  if (replay.differs_at) {
    return Conclude(Alone::kDiffers,
                    "other commands at " +
                        Fixed(kTickSeconds * static_cast<double>(*replay.differs_at), 3) +
                        " s, after " + std::to_string(replay.compared) + " equal ones",
                    answer);
  }
  if (replay.blind_at) {
    return Conclude(Alone::kSame, "same for " + steps + ", then the log has no images", answer);
  }
  if (!replay.complete) {
    return Conclude(Alone::kLogIsShort, "same for " + steps + ", then the log is cut short",
                    answer);
  }
  if (!replay.guarded) {
    Warn("the log has no check values, so nothing guards it against damage", &answer.warnings);
  }
  return Conclude(Alone::kSame, "same commands at all " + steps, answer);
}

/// The same; a program that fails must have failed so in the run.
Alone ReportController(const Folder& run_dir, const CampaignRun& run, const std::string& outcome,
                       const RunOptions& options, const std::vector<System>& systems,
                       ReplayAnswer& answer) {
  try {
    return ReportCommands(run_dir, run, options, systems, answer);
  } catch (const ControllerFailure& failure) {
    const bool same = failure.outcome() == outcome;
    return Conclude(same ? Alone::kSame : Alone::kDiffers,
                    std::string(same ? "fails as it did in the run" : "fails, unlike in the run") +
                        " (" + failure.what() + ")",
                    answer);
  }
}

int DrawFrames(const ReplayArguments& arguments, const KeptRun& kept, Invocation& call) {
  const System& system = FindSystem(call.systems, kept.run.scenario.system);
  const StageShapes shapes = ShapesToDraw(system, kept.run.scenario);
  const OutsideOptions outside = arguments.outside.options(shapes);
  const bool logged = kept.log_dir.HasFile(kRunLogFile);
  RunOptions options{.log_dir = {}, .labels = kept.columns.labels, .results_dir = arguments.dir};
  arguments.commands.Fill(options);
  if (arguments.recorded) options.recorded_dir = kept.commands_dir;
  const LoggedRun log =
      logged ? ReadLoggedRun(kept.log_dir) : LogAnew(system, kept.run, std::move(options));
  const std::filesystem::path dir = arguments.frames_dir;
  const int frames = WriteFilm(log, shapes, outside, arguments.period_s, dir);
  PrintNote(CountText(frames, "frame") + " in " + dir.string() + "; a film of them:");
  const std::string film = "ffmpeg -framerate " + NumberText(1.0 / arguments.period_s) + " -i " +
                           ShellWord((dir / "frame_%05d.png").string()) + " -pix_fmt yuv420p " +
                           ShellWord((dir / "film.mp4").string());
  ReplayAnswer answer{.as_json = arguments.json, .warnings = call.warnings};
  answer.Say(film);
  answer.json = {{"folder", dir.string()}, {"frames", frames}, {"film", film}};
  answer.Print();
  return log.complete ? kExitDone : kExitIncomplete;
}

/// Whether the log has some of the images alone.
bool HasImageGap(const Folder& dir) { return RunLogReader(dir).header().image_gap_s > 0.0; }

int Replay(const ReplayArguments& arguments, Invocation& call) {
  const KeptRun kept = FindKeptRun(arguments.dir, arguments.run, "replay", call);
  if (!arguments.frames_dir.empty()) return DrawFrames(arguments, kept, call);
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
  const System& system = FindSystem(call.systems, kept.run.scenario.system);
  RunOptions options{.log_dir = {}, .labels = kept.columns.labels, .results_dir = arguments.dir};
  arguments.commands.Fill(options);
  if (arguments.recorded) options.recorded_dir = kept.commands_dir;
  ReplayAnswer answer{.as_json = arguments.json, .warnings = call.warnings};
  const bool logged = kept.log_dir.HasFile(kRunLogFile);
  const bool thinned = logged && !arguments.recorded && HasImageGap(kept.log_dir);
  std::optional<PassingFolder> whole;  // the log of the run made again, with all images
  CampaignRun run = kept.run;
  if (thinned) {
    whole.emplace();
    options.log_dir = whole->path();
    run.scenario.log_image_gap_s = 0.0;
  }
  const RunRecord now = Simulate(system, run, options);
  const bool same_row = ReportRow(*kept.result, now.result, kept.columns, answer);
  if (!same_row && arguments.run) ReportEnvironment(arguments.dir);
  if (arguments.recorded) {
    answer.json["controller_alone"] = nullptr;
    answer.Print();
    return same_row ? kExitDone : kExitOurBug;
  }
  if (!logged) {
    PrintError("controller alone: not run, there is no log in " + kept.log_dir.path().string());
    answer.json["controller_alone"] = nullptr;
    answer.Print();
    return same_row ? kExitIncomplete : kExitOurBug;
  }
  if (thinned) answer.Say("controller alone: with the images of the run made again");
  const Alone alone = ReportController(thinned ? Folder(whole->path()) : kept.log_dir, kept.run,
                                       now.result.outcome, options, call.systems, answer);
  answer.Print();
  return same_row ? static_cast<int>(alone) : kExitOurBug;
}

}  // namespace

void AddReplayCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand("replay", kReplayHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign or of one run")
      ->required()
      ->type_name("DIR");
  command->add_option("RUN", arguments->run, "number of the run in a campaign");
  AddCommandOptions(*command, arguments->commands);
  command->add_option("--frames", arguments->frames_dir, "instead: folder for pictures of the run");
  command->add_option("--period", arguments->period_s, "simulated time from frame to frame [0.1 s]")
      ->type_name("SECONDS")
      ->check(NumberWithin(0.1, 60.0));
  command->add_flag("--recorded", arguments->recorded,
                    "give the commands that the log has, in place of the controller's program");
  command->add_flag("--json", arguments->json, "print what was found as JSON");
  AddOutsideOptions(*command, arguments->outside);
  AddSecretOption(*command, call);
  command->callback([arguments, &call] { call.exit_code = Replay(*arguments, call); });
}

}  // namespace dockyard
