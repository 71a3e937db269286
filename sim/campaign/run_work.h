// One run in a worker: its work and answer, and the reading of the answer.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/jobs/worker.h"
#include "sim/log/record.h"
#include "sim/log/results.h"
#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

using RunFunction =
    std::function<RunRecord(const CampaignRun& run, const std::filesystem::path& log_dir)>;

/// What a worker does with a run.
struct RunWork {
  RunFunction simulate;
  RowColumns columns;
};

/// In the worker: makes the run, simulates it, writes its files into its folder, if it
/// has one, and gives the answer as lines of text: row, timing and failure note, or the exception.
std::string RunAndAnswer(const std::function<CampaignRun()>& make, const RunWork& work,
                         const std::filesystem::path& run_dir);

/// In the parent: the run as the worker left it. A run that was lost has the outcome crashed or
/// stopped. Throws IoError and ConfigError where the worker did, because every other run would fail
/// the same way.
FinishedRun ReadAnswer(const std::function<CampaignRun()>& make, const RowColumns& columns,
                       const JobEnd& end);

/// Writes the files of a lost run into its folder, and closes its log. Throws IoError.
void WriteLostRun(const std::filesystem::path& run_dir, const FinishedRun& run,
                  const RowColumns& columns);

}  // namespace dockyard
