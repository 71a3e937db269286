// The shards of a results folder as tables, figures and a summary.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/campaign/row_check.h"
#include "sim/log/results.h"
#include "sim/plan/campaign.h"
#include "sim/run/system.h"

namespace dockyard {

/// All rows of a results folder, one for each run, in order of runs: its result, else the last row
/// of a run that was lost. Throws ResultsError, also when two rows hold different results of one
/// run and for a row that fails the check, UnsafeContent and IoError.
/// @param damaged  places of damaged lines, as "FILE:LINE", are added; may be null
FinishedRuns ReadShards(const std::filesystem::path& dir, const RowCheck& check,
                        const RowColumns& columns, std::vector<std::string>* damaged = nullptr);

/// Of a campaign that a sequential test ended (acceptance.json): leaves out the runs beyond the
/// last one that it counted. Which of them have rows depends on the number of workers. Returns
/// whether the test ended it.
bool LeaveOutUncounted(const std::filesystem::path& dir, FinishedRuns& runs);

/// Copies the shard files of another results folder of the same campaign and program into this one,
/// and the logs of its runs. The folder is made where it is missing.
/// Throws FolderTaken for another campaign, and for a shard file that both have and that is not the
/// same as far as both go; UnsafeContent, before anything is copied, and IoError.
void TakeShards(const std::filesystem::path& from, const std::filesystem::path& into);

/// What a campaign came to.
struct CampaignEnd {
  FinishedRuns runs;
  std::int64_t total = 0;  // planned
  std::string summary;
  std::vector<std::string> damaged;  // places of damaged rows, whose runs are missing

  bool complete() const { return static_cast<std::int64_t>(runs.size()) == total; }
};

/// Writes results.csv, timing.csv, results.sqlite, points, plots and summary.txt of the folder's
/// rows, and into its manifest where they were made; of a campaign that a sequential test ended, of
/// the runs that it counted. One program at a time does so in a folder: others wait. Throws
/// ResultsError, UnsafeContent, IoError, and FolderTaken after a wait of a minute.
CampaignEnd MergeShards(const std::filesystem::path& dir, const Campaign& campaign,
                        const RowColumns& columns);

}  // namespace dockyard
