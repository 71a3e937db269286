// One run in a worker: its work and answer, and the reading of the answer.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "sim/base/folder.h"
#include "sim/jobs/worker.h"
#include "sim/log/record.h"
#include "sim/log/results.h"
#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// What a run logs while it is simulated.
struct RunLogging {
  std::filesystem::path dir;  // empty: nothing
  bool images = true;
  bool commands_alone = false;     // RunLogHeader::commands_alone
  std::optional<Folder> recorded;  // its log gives the commands in place of the controller
};

using RunFunction = std::function<RunRecord(const CampaignRun& run, const RunLogging& logging)>;

/// What a worker does with a run.
struct RunWork {
  std::function<CampaignRun()> make;
  std::function<RunLogging(const CampaignRun&)> logging;
  const RunFunction& simulate;
  const RowColumns& columns;
  std::filesystem::path dir;  // for what it writes
  bool sightings = false;     // also without a log
};

/// In the worker: makes the run, simulates it, writes its files, if it has a log, and gives the
/// answer as lines of text: row, timing and failure note, or the exception.
std::string RunAndAnswer(const RunWork& work);

/// In the parent: the run as the worker left it. A run that was lost has the outcome crashed or
/// stopped. Throws IoError and ConfigError where the worker did, because every other run would fail
/// the same way.
FinishedRun ReadAnswer(const std::function<CampaignRun()>& make, const RowColumns& columns,
                       const JobEnd& end);

/// Writes the files of a lost run into its folder, and closes its log. Throws IoError.
void WriteLostRun(const std::filesystem::path& run_dir, const FinishedRun& run,
                  const RowColumns& columns);

}  // namespace dockyard
