// Runs of a system that does not exist: a campaign's handling of good, slow, crashing and hanging
// ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/log/record.h"
#include "sim/log/results.h"
#include "sim/scenario/scenario.h"
#include "support/bad_files.h"

namespace dockyard {

/// A folder of its own for each test, removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Labels soil and start.r_m; measures depth_m (headline), force_peak_n, yaw_error_deg; outcomes
/// docked, missed, timeout, crashed, stopped.
RowColumns FakeColumns();

/// Runs 1..count over two soils and nine ranges.
std::vector<CampaignRun> FakeRuns(int count);

/// A record that depends on the run alone; every third run fails.
RunRecord FakeRecord(const CampaignRun& run);
/// Results of FakeRuns(count), notes included.
FinishedRuns FakeResults(int count);

void WriteText(const std::filesystem::path& path, const std::string& text);

}  // namespace dockyard
