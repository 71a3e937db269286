#include "sim/report/summary.h"

#include <algorithm>
#include <vector>

#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/report/margins.h"
#include "sim/report/points.h"
#include "sim/report/rate_text.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostGroups =
    8;                         // a label with more values is a measure of the start, no group
constexpr int kLeastRuns = 2;  // of a group, on average: the table of runs has single ones
constexpr std::size_t kMostColumns = 99;
constexpr std::size_t kMostNumbers = 60;  // of runs with the same cause
// Beyond so many runs the table shows failures alone, and at most so many of them.
constexpr std::size_t kMostRows = 200, kMostFailures = 60;

using Cells = std::vector<std::string>;

/// Rows of one value of a label.
struct Group {
  std::string value;
  int successes = 0, runs = 0;
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

/// Empty cells would make a row hard to read; line breaks would break the table.
std::string CellOrDash(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text.empty() ? "-" : text;
}

/// Numbers in rising order; words stay in the order in which they first come.
void Sort(std::vector<Group>& groups) {
  const auto number = [](const Group& group) { return NumberFromText(group.value); };
  if (!std::all_of(groups.begin(), groups.end(), number)) return;
  std::stable_sort(groups.begin(), groups.end(), [&](const Group& a, const Group& b) {
    return number(a).value() < number(b).value();
  });
}

/// Cut where there are too many values to show.
std::vector<Group> GroupsBy(std::size_t label, const FinishedRuns& runs) {
  std::vector<Group> groups;
  for (const RunResult& result : runs.results) {
    if (groups.size() > kMostGroups) break;
    const std::string value = CellOrDash(result.labels[label]);
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& each) { return each.value == value; });
    if (group == groups.end()) group = groups.insert(groups.end(), {value});
    ++group->runs;
    group->successes += result.success ? 1 : 0;
  }
  Sort(groups);
  return groups;
}

void AddGroups(std::string& out, const std::vector<std::vector<Group>>& by_label,
               const RowColumns& columns, const std::string& word) {
  const auto shown = [](const std::vector<Group>& groups) {
    int runs = 0;
    for (const Group& group : groups) runs += group.runs;
    return groups.size() >= 2 && groups.size() <= kMostGroups &&
           runs >= kLeastRuns * static_cast<int>(groups.size());
  };
  std::size_t name_width = 0, value_width = 0;
  for (std::size_t i = 0; i < by_label.size(); ++i) {
    if (!shown(by_label[i])) continue;
    name_width = std::max(name_width, columns.labels[i].size());
    for (const Group& group : by_label[i]) value_width = std::max(value_width, group.value.size());
  }
  for (std::size_t i = 0; i < by_label.size(); ++i) {
    if (!shown(by_label[i])) continue;
    for (const Group& group : by_label[i]) {
      AddLine(out, "  " + Padded(columns.labels[i], name_width + 2) +
                       Padded(group.value, value_width + 2) + word + " " +
                       RateText(group.successes, group.runs));
    }
  }
}

/// "run 3", "runs 3 6 9", on as many lines as it takes.
void AddNumbers(std::string& out, std::string line, const std::vector<int>& numbers) {
  const std::size_t indent = line.size() + 5;
  line += numbers.size() == 1 ? "run" : "runs";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i == kMostNumbers) {
      line += " ...";
      break;
    }
    const std::string word = " " + std::to_string(numbers[i]);
    if (line.size() + word.size() > kMostColumns) {
      AddLine(out, line);
      line = std::string(indent - 1, ' ');
    }
    line += word;
  }
  AddLine(out, line);
}

void AddCauses(std::string& out, const FinishedRuns& runs, const RowColumns& columns) {
  std::vector<std::string> causes;
  for (const OutcomeName& outcome : columns.outcomes) causes.push_back(outcome.name);
  std::vector<std::vector<int>> numbers(causes.size());
  std::size_t width = 0;
  for (const RunResult& result : runs.results) {
    const auto cause = std::find(causes.begin(), causes.end(), result.outcome);
    if (result.success || cause == causes.end()) continue;
    numbers[static_cast<std::size_t>(cause - causes.begin())].push_back(result.run);
    width = std::max(width, cause->size());
  }
  if (width == 0) return;
  AddLine(out, "");
  AddLine(out, "failures by cause");
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (numbers[i].empty()) continue;
    AddNumbers(
        out,
        "  " + Padded(causes[i], width + 2) + Padded(std::to_string(numbers[i].size()) + " ", 4),
        numbers[i]);
  }
}

void AddMargins(std::string& out, const FinishedRuns& runs, const RowColumns& columns) {
  const std::vector<LimitOverRuns> limits = LimitsOverRuns(columns, runs.results);
  if (limits.empty()) return;
  std::size_t width = 0;
  for (const LimitOverRuns& each : limits) width = std::max(width, each.name.size());
  AddLine(out, "");
  AddLine(out, "limits: runs that broke them, and the least margin of those that " +
                   SuccessWord(columns, runs.results));
  for (const LimitOverRuns& each : limits) {
    const std::string count = std::to_string(each.broken) + "/" + std::to_string(each.judged);
    AddLine(out, "  " + Padded(each.name, width + 2) + Padded(count, 9) +
                     (each.least == nullptr ? ""
                                            : BriefNumber(each.least_margin) + " " + each.unit +
                                                  ", run " + std::to_string(each.least->run)));
  }
}

/// "r_m" of "start.r_m", where no other label ends so.
std::string ShortName(std::size_t label, const RowColumns& columns) {
  const auto last = [](const std::string& key) { return key.substr(key.rfind('.') + 1); };
  const std::string name = last(columns.labels[label]);
  const auto same = std::count_if(columns.labels.begin(), columns.labels.end(),
                                  [&](const std::string& each) { return last(each) == name; });
  return same == 1 && !name.empty() ? name : columns.labels[label];
}

/// Whether the label `repeat` only says the runs' numbers again: all runs repeat one point.
bool IsRunNumber(std::size_t label, const FinishedRuns& runs, const RowColumns& columns) {
  if (columns.labels[label] != "repeat") return false;
  return std::all_of(runs.results.begin(), runs.results.end(), [&](const RunResult& row) {
    return row.labels[label] == std::to_string(row.run);
  });
}

/// A line of cells, as wide as their columns' longest: numbers to the right, words to the left. A
/// column of no width is left out.
std::string TableLine(const Cells& cells, const std::vector<std::size_t>& widths,
                      const std::vector<char>& numeric) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (widths[i] == 0) continue;
    const std::string space(widths[i] - cells[i].size(), ' ');
    line += (i == 0 ? "" : "  ") + (numeric[i] ? space + cells[i] : cells[i] + space);
  }
  return line;
}

/// A label as the table shows it: a drawn number has more digits than a reader wants.
std::string LabelCell(const std::string& label) {
  constexpr std::size_t kMostDigits = 7;
  const auto number = label.size() > kMostDigits ? NumberFromText(label) : std::nullopt;
  return number ? BriefNumber(*number) : CellOrDash(label);
}

Cells TableCells(const RunResult& row, const std::vector<std::size_t>& labels,
                 const RowColumns& columns) {
  Cells cells{std::to_string(row.run)};
  for (const std::size_t label : labels) cells.push_back(LabelCell(row.labels[label]));
  cells.insert(cells.end(), {row.outcome, Fixed(row.sim_time_s, 1), std::to_string(row.images)});
  for (std::size_t i = 0; i < columns.measures.size(); ++i) {
    if (!columns.measures[i].headline) continue;
    cells.push_back(row.measures.empty() ? "-" : BriefNumber(row.measures[i]));
  }
  return cells;
}

/// All runs, or where there are many, the first failures.
std::vector<std::size_t> ShownRuns(const FinishedRuns& runs) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs.size() > kMostRows && (runs.results[i].success || shown.size() == kMostFailures)) {
      continue;
    }
    shown.push_back(i);
  }
  return shown;
}

/// Takes the width of labels, the last ones first, until a line has room. Labels follow the run's
/// number. Returns how many it took.
std::size_t LeaveOutLabels(std::size_t labels, std::vector<std::size_t>& widths) {
  std::size_t total = 0, left_out = 0;
  for (const std::size_t width : widths) total += width + 2;
  for (std::size_t i = labels; i > 0 && total > kMostColumns + 2; --i) {
    total -= widths[i] + 2;
    widths[i] = 0;
    ++left_out;
  }
  return left_out;
}

void AddTable(std::string& out, const FinishedRuns& runs, const RowColumns& columns,
              const std::vector<std::size_t>& labels) {
  Cells header{"run"};
  for (const std::size_t label : labels) header.push_back(ShortName(label, columns));
  header.insert(header.end(), {"outcome", "time_s", "images"});
  for (const Column& measure : columns.measures) {
    if (measure.headline) header.push_back(measure.name);
  }
  std::vector<Cells> table;
  const std::vector<std::size_t> shown = ShownRuns(runs);
  for (const std::size_t i : shown) table.push_back(TableCells(runs.results[i], labels, columns));
  std::vector<std::size_t> widths;
  std::vector<char> numeric(header.size(), 1);
  for (const std::string& cell : header) widths.push_back(cell.size());
  for (const Cells& cells : table) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      widths[i] = std::max(widths[i], cells[i].size());
      if (cells[i] != "-" && !NumberFromText(cells[i])) numeric[i] = 0;
    }
  }
  const std::size_t left_out = LeaveOutLabels(labels.size(), widths);
  AddLine(out, "");
  AddLine(out, TableLine(header, widths, numeric));
  auto line = table.begin();
  for (const std::size_t i : shown) {
    AddLine(out, TableLine(*line++, widths, numeric));
    if (!runs.notes[i].empty()) AddLine(out, std::string(widths[0] + 2, ' ') + runs.notes[i]);
  }
  if (left_out > 0) {
    AddLine(out, CountText(left_out, "more label is", "more labels are") + " in results.csv");
  }
  if (shown.size() < runs.size()) {
    AddLine(out, "of " + std::to_string(runs.size()) + " runs the first " +
                     CountText(shown.size(), "failure") + "; results.csv has all");
  }
}

}  // namespace

std::string SummaryText(const std::string& title, const FinishedRuns& runs,
                        const RowColumns& columns, std::int64_t total, bool enough) {
  const Rows unchanged = UnchangedRows(runs.results, columns);
  int successes = 0;
  for (const RunResult* result : unchanged) successes += result->success ? 1 : 0;
  const int done = static_cast<int>(runs.size()), counted = static_cast<int>(unchanged.size());
  const std::string word = SuccessWord(columns, runs.results);
  std::string out;
  AddLine(out, title + ": " + word + " " + RateText(successes, counted) +
                   ", 95 % intervals (Clopper-Pearson)");
  if (counted < done) {
    AddLine(out, "not counted there: " + CountText(done - counted, "run") +
                     " in which a key was changed alone (points.md)");
  }
  if (done < total) {
    AddLine(out, (enough ? "ended early, by --until-accepted: " : "incomplete: ") +
                     std::to_string(done) + " of " + CountText(total, "run"));
  }
  std::vector<std::vector<Group>> by_label;
  std::vector<std::size_t> differing;
  for (std::size_t i = 0; i < columns.labels.size(); ++i) {
    by_label.push_back(IsRunNumber(i, runs, columns) ? std::vector<Group>{} : GroupsBy(i, runs));
    if (by_label[i].size() > 1) differing.push_back(i);
    if (by_label[i].size() == 1) {
      AddLine(out, "all runs: " + columns.labels[i] + " " + by_label[i].front().value);
    }
  }
  AddLine(out, "");
  AddGroups(out, by_label, columns, word);
  AddCauses(out, runs, columns);
  AddMargins(out, runs, columns);
  AddTable(out, runs, columns, differing);
  return out;
}

}  // namespace dockyard
