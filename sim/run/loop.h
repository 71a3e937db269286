// One run in closed loop: a pure function of the scenario.
#pragma once

#include <filesystem>
#include <optional>

#include "sim/base/folder.h"
#include "sim/log/record.h"
#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

struct RunOptions {
  std::filesystem::path log_dir;    // empty: no log is written
  bool log_images = true;           // in the log, if the scenario keeps them
  bool log_commands_alone = false;  // what a run needs to be made again without its program
  std::vector<std::string> labels;  // names of the run's labels
  // Whether a scenario's `controller: {command: ...}` may start its program, and how long one of
  // its answers may take. Wall time; assumed, 1-60 s.
  bool allow_commands = false;
  double answer_limit_s = 10.0;
  // Whether such a program is confined, and the folder of results that it must not read then.
  bool sandbox = false;
  std::filesystem::path results_dir = {};
  double run_limit_s = 0.0;  // wall time, then the run is stopped; 0: no limit
  // A run's folder whose log gives the commands in place of the controller.
  std::optional<Folder> recorded_dir = std::nullopt;
};

/// Throws ConfigError for a scenario whose controller is a program that may not be started, and
/// SandboxError where it is to be confined and cannot be. Hides this process's memory from a
/// program that may.
void RequireAllowed(const Scenario& scenario, const RunOptions& options);

/// A new controller as the scenario names it, made from the run's nominal parameters. Throws
/// ConfigError, also for a command that the options do not allow, and ControllerFailure for a
/// command.
std::unique_ptr<Controller> MakeController(const System& system, const CampaignRun& run,
                                           const ReadyRun& ready, const RunOptions& options);

/// What a program gets as the seed of its own draws: a map of `controller: {seed: N}` and the run's
/// number. The world has no part in it, so it shows nothing of the world.
std::uint64_t SeedOfProgram(std::uint64_t controller_seed, int run);

/// Whether the run's controller is a program, by its row: `command` (docs/reference/columns.md).
bool StartsProgram(const RunResult& row);

/// The part of a result that is known before the run. The row of a crashed run holds no more.
RunResult StartOfRow(const CampaignRun& run);

/// Simulates the run and scores it. Throws ConfigError for files that cannot be read and IoError
/// for a folder that cannot be written; everything else is an outcome.
RunRecord Simulate(const System& system, const CampaignRun& run, const RunOptions& options);

}  // namespace dockyard
