// One run in a process of its own: the child's work and answer, and the reading of the answer.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/jobs/child.h"
#include "sim/log/record.h"
#include "sim/log/results.h"
#include "sim/run/system.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

using RunFunction =
    std::function<RunRecord(const CampaignRun& run, const std::filesystem::path& log_dir)>;
using DrawRun = std::function<std::vector<Figure>(const RunRecord&, const Scenario&)>;

/// Writes each figure as a file of the folder, which exists. Throws IoError.
void WriteFigures(const std::filesystem::path& dir, const std::vector<Figure>& figures);

/// The work of a run's process.
struct RunWork {
  RunFunction simulate;
  DrawRun draw;  // empty: it draws nothing
  RowColumns columns;
};

/// In the child: simulates, writes the run's files and figures into its folder, if it has one, and
/// gives the answer as lines of text: row, timing and failure note, or the exception.
std::string RunAndAnswer(const CampaignRun& run, const RunWork& work,
                         const std::filesystem::path& run_dir);

/// In the parent: the run as the child left it. When the child died or threw another exception than
/// those below, this writes a row with the outcome crashed and the files for it. Throws IoError and
/// ConfigError where the child did, because every other run would fail the same way.
FinishedRun ReadAnswer(const CampaignRun& run, const RowColumns& columns,
                       const std::filesystem::path& run_dir, const Child::End& child);

}  // namespace dockyard
