// A process that does pieces of work one after another: a crash costs only the piece under way.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dockyard {

/// Gets the job's number and the file into which it prints; returns its answer. Must not throw.
using JobWork = std::function<std::string(std::int64_t job, const std::filesystem::path& messages)>;

struct JobLimits {
  double wall_s = 900.0;           // wall time of one job, > 0
  std::int64_t memory_mib = 2048;  // data of a worker beyond that of its parent at the start, > 0
};

/// Why a job has no answer.
enum class Loss {
  kNone,
  kCrashed,  // by its own fault: a signal such as SIGSEGV, or an exit
  kStopped,  // by a limit, or killed by somebody else
};

/// The result of a job: its answer, or how it was lost.
struct JobEnd {
  std::string answer;
  Loss loss = Loss::kNone;
  std::string how_it_died;  // a phrase; empty without loss
  double cpu_time_s = 0.0, wall_time_s = 0.0;
};

/// A forked process. It dies with its parent, ignores Ctrl-C (the parent handles it), leaves no
/// core file, and prints into the file of the job under way.
class Worker {
 public:
  /// @param close_in_worker  descriptors that are the parent's alone
  /// Throws IoError when no process can be had.
  Worker(const JobWork& work, const JobLimits& limits, const std::vector<int>& close_in_worker);
  /// Kills the process.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Hands it a job; it has none under way.
  /// @param messages  file for what the job prints; it is emptied first
  void Start(std::int64_t job, const std::filesystem::path& messages);

  int descriptor() const { return answers_; }  // readable when there is something to read
  pid_t process() const { return process_; }
  /// The parent's own ends of its pipes, which other workers must close.
  std::vector<int> descriptors() const { return {tasks_, answers_}; }
  /// Takes the bytes that have come; true when the job has ended, one way or the other.
  bool Read();
  /// Kills the process when the job's time is over.
  void KillIfLate();
  double seconds_left() const;
  /// Gives the job that much more time, as when the parent itself stood still.
  void Extend(double seconds);
  /// After Read was true.
  JobEnd Finish();
  /// Whether it can take another job: after a lost one it cannot.
  bool usable() const { return !gone_ && !late_; }

 private:
  using Clock = std::chrono::steady_clock;

  double CpuTime() const;
  JobEnd Lost(double wall_s);

  JobLimits limits_;
  Clock::time_point started_, deadline_;
  double cpu_at_start_s_ = 0.0;
  pid_t process_ = -1;
  int tasks_ = -1, answers_ = -1;
  bool late_ = false, gone_ = false;
  std::string received_;
};

}  // namespace dockyard
