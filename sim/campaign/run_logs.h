// Which runs of a campaign write a log, when, and where the logs stay.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "sim/base/folder.h"
#include "sim/campaign/retention.h"
#include "sim/campaign/run_work.h"
#include "sim/log/record.h"
#include "sim/log/result_row.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// A simulation of a run: for its row, or again for its log.
struct Pass {
  std::int64_t index = 0;  // of the run
  bool again = false;
};
/// As the number of a job.
std::int64_t NumberOf(const Pass& pass);
Pass PassOf(std::int64_t number);

/// What a run writes. A log costs 5 to 16 % of a run (measured on the three systems), so a run
/// whose log would be dropped writes none. A success that stays is known by its number. A failure
/// that stays is simulated again with its log, which proves each time that the run can be repeated.
/// A program need not answer twice alike: its run always logs the commands, and the second
/// simulation takes them from there.
/// @param work_dir  the folder that the run writes
/// @param results   the campaign's
RunLogging LoggingOf(const CampaignRun& run, const Keep& keep, bool again,
                     const std::filesystem::path& work_dir, const Folder& results);

/// A run whose second simulation came to another row.
struct NotRepeated {
  int run = 0;
  std::vector<DifferingCell> cells;  // empty: it was lost
};

/// The logs in a results folder, while a campaign adds runs to it.
class RunLogs {
 public:
  /// The columns must outlive it.
  RunLogs(const Keep& keep, const Folder& results, const RowColumns& columns);

  /// Of a run that has its row from an earlier program, in order of runs, before all others.
  void AddEarlier(std::int64_t index, const RunResult& result);
  /// Of a run's first simulation. Takes what it left in its work folder, a place in the results.
  void TakeRow(std::int64_t index, const FinishedRun& run, const std::filesystem::path& work);
  /// Of its second.
  void TakeLog(std::int64_t index, const FinishedRun& run, const std::filesystem::path& work);
  /// The next run to simulate again.
  std::optional<std::int64_t> NextAgain();

  const std::vector<NotRepeated>& not_repeated() const { return not_repeated_; }

 private:
  bool Chosen(const RunResult& result);
  void Move(const std::filesystem::path& from, const std::filesystem::path& to) const;
  void KeepCommands(int run, const std::filesystem::path& from) const;
  void KeepWhole(const FinishedRun& run, const std::filesystem::path& work) const;
  void KeepSightings(const FinishedRun& run, const std::filesystem::path& work) const;
  void Drop(int run);

  Keep keep_;
  Folder results_;
  const RowColumns& columns_;
  Retention retention_;
  std::set<std::int64_t> to_simulate_;           // again
  std::map<std::int64_t, FinishedRun> waiting_;  // rows of those, and of those at work
  std::set<int> of_programs_;                    // of those that stay
  std::vector<NotRepeated> not_repeated_;
};

}  // namespace dockyard
