#include "sim/campaign/summary.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <vector>

#include "models/number_text.h"
#include "sim/campaign/statistics.h"

namespace dockyard {
namespace {

struct Count {
  int docked = 0, runs = 0;
};

std::string Padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

// Trailing spaces make diffs of tables noisy.
void AddLine(std::string& out, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  out += line + "\n";
}

void AddGroup(std::string& out, const std::string& name, const FinishedRuns& runs,
              const std::function<std::string(const RunResult&)>& key) {
  std::map<std::string, Count> counts;
  for (const auto& [number, run] : runs) {
    Count& count = counts[key(run.result)];
    ++count.runs;
    count.docked += run.result.docked ? 1 : 0;
  }
  if (counts.size() < 2) return;  // one group says what the total says
  for (const auto& [value, count] : counts) {
    AddLine(out, "  " + Padded(name, 8) + Padded(value.empty() ? "-" : value, 14) +
                     BriefRate(count.docked, count.runs));
  }
}

void AddCauses(std::string& out, const FinishedRuns& runs) {
  std::map<Outcome, std::vector<int>> causes;
  for (const auto& [number, run] : runs) {
    if (!run.result.docked) causes[run.result.outcome].push_back(number);
  }
  if (causes.empty()) return;
  AddLine(out, "");
  AddLine(out, "failures by cause");
  for (const auto& [outcome, numbers] : causes) {
    std::string list;
    for (const int number : numbers) list += " " + std::to_string(number);
    AddLine(out, "  " + Padded(Name(outcome), 22) + Padded(std::to_string(numbers.size()), 4) +
                     (numbers.size() == 1 ? "run" : "runs") + list);
  }
}

void AddTable(std::string& out, const FinishedRuns& runs, const std::map<int, std::string>& notes) {
  AddLine(out, "");
  AddLine(out,
          "run  soil     light        r_m  alpha  head  outcome               time_s  pairs  rec  "
          "depth_cm");
  for (const auto& [number, run] : runs) {
    const RunResult& row = run.result;
    char line[160];
    std::snprintf(line, sizeof line,
                  "%3d  %-8s %-11s %4.1f  %5.0f %5.0f  %-20s  %6.1f  %5d  %3d  %8s", number,
                  row.soil.c_str(), row.light.c_str(), row.r_m, row.alpha_deg, row.heading_deg,
                  Name(row.outcome), row.sim_time_s, row.image_pairs, row.recoveries,
                  Fixed(100.0 * row.tip_depth_m, 1).c_str());
    AddLine(out, line);
    const auto note = notes.find(number);
    if (note != notes.end() && !note->second.empty()) AddLine(out, "     " + note->second);
  }
}

}  // namespace

std::string SummaryText(const std::string& title, const FinishedRuns& runs, int total,
                        const std::map<int, std::string>& notes) {
  int docked = 0;
  for (const auto& [number, run] : runs) docked += run.result.docked ? 1 : 0;
  const int done = static_cast<int>(runs.size());
  std::string out;
  AddLine(out, title + ": " + BriefRate(docked, done) + ", 95 % intervals (Clopper-Pearson)");
  if (done < total) {
    AddLine(out, "incomplete: " + std::to_string(done) + " of " + std::to_string(total) + " runs");
  }
  AddLine(out, "");
  AddGroup(out, "region", runs, [](const RunResult& row) { return row.region; });
  AddGroup(out, "light", runs, [](const RunResult& row) { return row.light; });
  AddGroup(out, "soil", runs, [](const RunResult& row) { return row.soil; });
  AddGroup(out, "day", runs, [](const RunResult& row) { return std::to_string(row.day); });
  AddCauses(out, runs);
  AddTable(out, runs, notes);
  return out;
}

}  // namespace dockyard
