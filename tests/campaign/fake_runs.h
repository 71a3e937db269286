// Runs without a world: what a campaign does with good, slow, crashing and hanging ones.
#pragma once

#include <filesystem>
#include <string>

#include "models/scenario.h"
#include "sim/campaign/worker.h"
#include "sim/run/record.h"

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

/// Runs 1..count over both soils, three lights, spread over the grid.
Campaign FakeCampaign(int count);

/// A record that depends on the run alone; every third run fails.
RunRecord FakeRecord(const CampaignRun& run);

/// FakeRecord, later for runs of odd number, so that runs do not end in order.
RunRecord FakeRun(const CampaignRun& run, const std::filesystem::path& log_dir);

std::string ReadText(const std::filesystem::path& path);
void WriteText(const std::filesystem::path& path, const std::string& text);

}  // namespace dockyard
