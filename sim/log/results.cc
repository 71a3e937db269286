#include "sim/log/results.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "controller/base/check.h"
#include "sim/base/files.h"
#include "sim/base/text.h"
#include "sim/log/result_row.h"

namespace dockyard {

void FinishedRuns::Add(FinishedRun run) {
  DOCKYARD_CHECK(results.empty() || results.back().run < run.result.run);
  results.push_back(std::move(run.result));
  timings.push_back(run.timing);
  notes.push_back(std::move(run.note));
}

std::size_t FinishedRuns::Find(int run) const {
  const auto at =
      std::lower_bound(results.begin(), results.end(), run,
                       [](const RunResult& result, int number) { return result.run < number; });
  return at == results.end() || at->run != run ? size()
                                               : static_cast<std::size_t>(at - results.begin());
}

std::string SuccessWord(const RowColumns& columns, const std::vector<RunResult>& rows) {
  std::set<std::string> words;
  for (const RunResult& row : rows) {
    if (!row.success_word.empty()) words.insert(row.success_word);
  }
  const bool none = words.empty();
  for (const OutcomeName& each : columns.outcomes) {
    if (none && each.success) words.insert(each.name);
  }
  if (words.size() != 1) return "succeeded";
  std::string word = *words.begin();
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

std::vector<std::string> TimingNames() {
  return {"cpu_time_s", "wall_time_s", "controller_cpu_s", "controller_wall_s"};
}

std::vector<std::string> TimingCells(const RunTiming& timing) {
  return {NumberText(timing.cpu_time_s), NumberText(timing.wall_time_s),
          NumberText(timing.controller_cpu_s), NumberText(timing.controller_wall_s)};
}

std::optional<RunTiming> TimingFromCells(const std::vector<std::string>& cells) {
  RunTiming timing;
  double* const parts[] = {&timing.cpu_time_s, &timing.wall_time_s, &timing.controller_cpu_s,
                           &timing.controller_wall_s};
  if (cells.size() != std::size(parts)) return std::nullopt;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto number = NumberFromText(cells[i]);
    if (!number) return std::nullopt;
    *parts[i] = *number;
  }
  return timing;
}

std::string TimingHeader() {
  std::string header = "run";
  for (const std::string& name : TimingNames()) header += "," + name;
  return header;
}

void WriteResultsCsv(const std::filesystem::path& path, const FinishedRuns& runs,
                     const RowColumns& columns) {
  WholeFile file(path);
  file.Add(CsvHeader(columns) + "\n");
  for (const RunResult& result : runs.results) file.Add(CsvRow(result, columns) + "\n");
  file.Finish();
}

void WriteTimingCsv(const std::filesystem::path& path, const FinishedRuns& runs) {
  WholeFile file(path);
  file.Add(TimingHeader() + "\n");
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::string line = std::to_string(runs.results[i].run);
    for (const std::string& cell : TimingCells(runs.timings[i])) line += "," + cell;
    file.Add(line + "\n");
  }
  file.Finish();
}

std::vector<RunResult> RowsFromCsv(std::string_view bytes, const std::string& file,
                                   const RowColumns& columns) {
  const std::string header = CsvHeader(columns);
  const RowColumns former = FormerColumns(columns);
  const RowColumns* of_file = &columns;
  std::vector<RunResult> rows;
  for (int number = 1; !bytes.empty(); ++number) {
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) break;  // cut off while it was written
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    const std::string at = file + ":" + std::to_string(number) + ": ";
    if (number == 1 && line == CsvHeader(former)) of_file = &former;
    if (number == 1 && line != header && of_file == &columns) {
      throw ResultsError(at + "expected the columns '" + header + "'");
    }
    if (number == 1) continue;
    const auto row = RowFromCsv(line, *of_file);
    if (!row) throw ResultsError(at + "not a row of " + file);
    rows.push_back(*row);
  }
  return rows;
}

}  // namespace dockyard
