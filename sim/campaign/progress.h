// The progress of a campaign: on stderr, or for programs on stdout; never among the results.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "sim/campaign/finished_set.h"
#include "sim/log/results.h"

namespace dockyard {

enum class ProgressStyle {
  kNone,
  kLines,  // a line per finished run, for files and pipes
  kLive,   // one line that is written over, for terminals
  kJson,   // an object per finished run on stdout, a line each
};

/// kLive when stderr is a terminal that can do it.
ProgressStyle ProgressStyleOfStderr();

class Progress {
 public:
  /// @param word   of a success (SuccessWord)
  /// @param total  runs that this program has to do, those done already included
  Progress(ProgressStyle style, std::string word, std::int64_t total, const Tally& already);

  void Finished(const FinishedRun& run);
  /// Refreshes the live line; call it now and then.
  void Tick(int running);
  /// Ends the live line.
  void End();

 private:
  std::string Line(int running) const;

  ProgressStyle style_;
  std::string word_;
  std::int64_t total_, done_before_;
  Tally tally_;
  std::chrono::steady_clock::time_point started_, ticked_;
};

/// "12/40 done, docked 11/12 (92 %, 62-100 %), timeout 1"
std::string TallyText(const Tally& tally, std::int64_t total, const std::string& word);

/// "2 h 5 min", "12 min 30 s", "45 s"
std::string DurationText(double seconds);

}  // namespace dockyard
