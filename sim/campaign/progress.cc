#include "sim/campaign/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace dockyard {

ProgressStyle ProgressStyleOfStderr() {
  const char* terminal = std::getenv("TERM");
  const bool can_overwrite = terminal != nullptr && std::string_view(terminal) != "dumb";
  return ::isatty(STDERR_FILENO) && can_overwrite ? ProgressStyle::kLive : ProgressStyle::kLines;
}

std::string DurationText(double seconds) {
  const long s = std::lround(seconds);
  if (s >= 3600) return std::to_string(s / 3600) + " h " + std::to_string(s / 60 % 60) + " min";
  if (s >= 60) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s) + " s";
}

Progress::Progress(ProgressStyle style, std::int64_t total, const FinishedRuns& already)
    : style_(style), total_(total), started_(std::chrono::steady_clock::now()) {
  for (const auto& [number, run] : already) docked_ += run.result.docked ? 1 : 0;
  done_ = done_before_ = static_cast<int>(already.size());
}

std::string Progress::Line(int running) const {
  std::string line = std::to_string(done_) + "/" + std::to_string(total_) + " done, docked " +
                     std::to_string(docked_);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
  const int finished_now = done_ - done_before_;
  if (finished_now > 0 && spent.count() > 0.0) {
    const double per_minute = 60.0 * finished_now / spent.count();
    char rate[64];
    std::snprintf(rate, sizeof rate, ", %.1f runs/min", per_minute);
    line += rate;
    if (done_ < total_)
      line +=
          ", " + DurationText(60.0 * static_cast<double>(total_ - done_) / per_minute) + " left";
  }
  if (running > 0) line += ", " + std::to_string(running) + " running";
  return line;
}

void Progress::Finished(const RunResult& row, const std::string& note) {
  ++done_;
  docked_ += row.docked ? 1 : 0;
  const std::string what = "run " + std::to_string(row.run) + ": " + row.outcome +
                           (note.empty() ? "" : " (" + note + ")");
  if (style_ == ProgressStyle::kLines) {
    std::fprintf(stderr, "%s; %s\n", what.c_str(), Line(0).c_str());
  } else if (style_ == ProgressStyle::kLive && !note.empty()) {
    std::fprintf(stderr, "\r\x1b[K%s\n", what.c_str());
  }
}

void Progress::Tick(int running) {
  if (style_ == ProgressStyle::kLive) std::fprintf(stderr, "\r\x1b[K%s", Line(running).c_str());
}

void Progress::End() {
  if (style_ == ProgressStyle::kLive) std::fprintf(stderr, "\r\x1b[K%s\n", Line(0).c_str());
}

}  // namespace dockyard
