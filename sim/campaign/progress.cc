#include "sim/campaign/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "models/read/text_file.h"
#include "sim/base/json.h"
#include "sim/report/rate_text.h"

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

std::string TallyText(const Tally& tally, std::int64_t total, const std::string& word) {
  std::string text = std::to_string(tally.done) + "/" + std::to_string(total) + " done, " + word +
                     " " +
                     RateText(static_cast<int>(tally.successes), static_cast<int>(tally.done));
  std::vector<std::pair<std::int64_t, std::string>> causes;
  for (const auto& [outcome, count] : tally.failures) causes.push_back({-count, outcome});
  std::sort(causes.begin(), causes.end());
  constexpr std::size_t kMostShown = 3;
  for (std::size_t i = 0; i < causes.size() && i < kMostShown; ++i) {
    text += ", " + causes[i].second + " " + std::to_string(-causes[i].first);
  }
  return text;
}

Progress::Progress(ProgressStyle style, std::string word, std::int64_t total, const Tally& already)
    : style_(style),
      word_(std::move(word)),
      total_(total),
      done_before_(already.done),
      tally_(already),
      started_(std::chrono::steady_clock::now()) {}

std::string Progress::Line(int running) const {
  std::string line = TallyText(tally_, total_, word_);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - started_;
  const std::int64_t finished_now = tally_.done - done_before_;
  // The first run alone ends as soon as it is read: it shows no rate.
  constexpr double kLeastSpent_s = 1.0;
  if (finished_now > 1 && spent.count() >= kLeastSpent_s) {
    const double per_minute = 60.0 * static_cast<double>(finished_now) / spent.count();
    char rate[64];
    std::snprintf(rate, sizeof rate, ", %.1f runs/min", per_minute);
    line += rate;
    if (tally_.done < total_) {
      const auto left = static_cast<double>(total_ - tally_.done);
      line += ", " + DurationText(60.0 * left / per_minute) + " left";
    }
  }
  if (running > 0) line += ", " + std::to_string(running) + " running";
  return line;
}

void Progress::Finished(const FinishedRun& run) {
  const RunResult& row = run.result;
  ++tally_.done;
  tally_.successes += row.success ? 1 : 0;
  if (!row.success) ++tally_.failures[row.outcome];
  const bool lost = IsLost(row.outcome);
  tally_.lost += lost ? 1 : 0;
  const std::string what = "run " + std::to_string(row.run) + ": " + row.outcome +
                           (lost ? " (" + WithControlsShown(run.note) + ")" : "");
  if (style_ == ProgressStyle::kLines) {
    std::fprintf(stderr, "%s; %s\n", what.c_str(), Line(0).c_str());
  } else if (style_ == ProgressStyle::kLive && lost) {
    std::fprintf(stderr, "\r\x1b[K%s\n", what.c_str());
  } else if (style_ == ProgressStyle::kJson) {
    const Json line{{"run", row.run},         {"outcome", row.outcome},
                    {"success", row.success}, {"docked", row.success},  // the former name
                    {"note", run.note},       {"done", tally_.done},
                    {"total", total_},        {"successes", tally_.successes},
                    {"lost", tally_.lost}};
    std::printf("%s\n", line.dump().c_str());
    std::fflush(stdout);
  }
}

// Once a second is enough for people.
void Progress::Tick(int running) {
  const auto now = std::chrono::steady_clock::now();
  if (style_ != ProgressStyle::kLive || now - ticked_ < std::chrono::seconds(1)) return;
  ticked_ = now;
  std::fprintf(stderr, "\r\x1b[K%s", Line(running).c_str());
}

void Progress::End() {
  if (style_ == ProgressStyle::kLive) std::fprintf(stderr, "\r\x1b[K%s\n", Line(0).c_str());
}

}  // namespace dockyard
