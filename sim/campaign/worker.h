// One run in a process of its own: what the child does and answers, and how the answer is read.
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

/// What a run's process does.
struct RunWork {
  RunFunction simulate;
  DrawRun draw;  // empty: it draws nothing
  RowColumns columns;
};

/// In the child: simulates, writes the run's files and figures into its folder, and gives the
/// answer as lines of text: row, timing and failure note, or what was thrown.
std::string RunAndAnswer(const CampaignRun& run, const RunWork& work,
                         const std::filesystem::path& run_dir);

/// In the parent: the run as the child left it. A child that died, or threw what is not the
/// campaign's matter, leaves a row with the outcome crashed and the files to it. Throws IoError and
/// ConfigError where the child did: every other run would fail the same way.
FinishedRun ReadAnswer(const CampaignRun& run, const RowColumns& columns,
                       const std::filesystem::path& run_dir, const Child::End& child);

}  // namespace dockyard
