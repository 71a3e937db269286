// The progress of a campaign: on stderr, never among the results.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "sim/log/results.h"

namespace dockyard {

enum class ProgressStyle {
  kNone,
  kLines,  // a line per finished run, for files and pipes
  kLive,   // one line that is written over, for terminals
};

/// kLive when stderr is a terminal that can do it.
ProgressStyle ProgressStyleOfStderr();

class Progress {
 public:
  Progress(ProgressStyle style, std::int64_t total, const FinishedRuns& already);

  void Finished(const RunResult& row, const std::string& note);
  /// Refreshes the live line; call it now and then.
  void Tick(int running);
  /// Ends the live line.
  void End();

 private:
  std::string Line(int running) const;

  ProgressStyle style_;
  std::int64_t total_;
  int done_ = 0, docked_ = 0, done_before_ = 0;
  std::chrono::steady_clock::time_point started_;
};

/// "2 h 5 min", "12 min 30 s", "45 s"
std::string DurationText(double seconds);

}  // namespace dockyard
