// One run in a process of its own: whatever it does, it costs that run and no other.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "models/scenario.h"
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

/// A forked child that runs one run, writes its files and answers with its row over a pipe. The
/// child dies with its parent, ignores Ctrl-C (the parent's matter), leaves no core file, and
/// prints into messages.txt of its folder.
class Worker {
 public:
  /// @param close_in_child  descriptors that are the parent's alone
  /// Throws IoError when no process can be had.
  Worker(const CampaignRun& run, const RunFunction& function, const std::filesystem::path& run_dir,
         double time_limit_s, const std::vector<int>& close_in_child);
  /// Kills the child if it still runs.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  int descriptor() const { return pipe_; }  // readable when there is something to read
  /// Takes what the child has sent; true when it has said all.
  bool Read();
  /// Kills the child when its time is over.
  void KillIfLate();
  double seconds_left() const;
  /// Waits for the child and gives its result. Throws IoError and InputError if the child did.
  WorkerEnd Finish();

 private:
  using Clock = std::chrono::steady_clock;

  WorkerEnd Crashed(const std::string& note, double cpu_time_s) const;

  CampaignRun run_;
  std::filesystem::path run_dir_;
  double time_limit_s_;
  Clock::time_point started_;
  pid_t child_ = -1;
  int pipe_ = -1;
  bool late_ = false;
  std::string answer_;
};

}  // namespace dockyard
