// One run in a process of its own: whatever it does, it costs that run and no other.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "models/scenario.h"
#include "sim/campaign/child.h"
#include "sim/campaign/results.h"
#include "sim/run/record.h"

namespace dockyard {

using RunFunction =
    std::function<RunRecord(const CampaignRun& run, const std::filesystem::path& log_dir)>;

/// An input file proved bad when a run read it. A run function throws it to end the campaign: every
/// other run would fail the same way.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a worker left: a row, whether the run came to its end or not.
struct WorkerEnd {
  FinishedRun run;
  bool crashed = false;
  std::string note;  // how it crashed
};

/// A child that runs one run, writes its files and answers with its row.
class Worker {
 public:
  /// @param close_in_child  descriptors that are the parent's alone
  /// Throws IoError when no process can be had.
  Worker(const CampaignRun& run, const RunFunction& function, const std::filesystem::path& run_dir,
         double time_limit_s, const std::vector<int>& close_in_child);

  Child& child() { return child_; }
  /// Waits for the child and gives its result. Throws IoError and InputError if the child did.
  WorkerEnd Finish();

 private:
  WorkerEnd Crashed(const std::string& note, const Child::End& child) const;

  CampaignRun run_;
  std::filesystem::path run_dir_;
  Child child_;
};

}  // namespace dockyard
