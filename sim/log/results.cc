#include "sim/log/results.h"

#include <functional>
#include <optional>

#include "sim/base/files.h"
#include "sim/base/text.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

/// Gives every whole line after the header to `read`, which returns whether it is a row.
void ReadLines(std::string_view bytes, const std::string& file, const std::string& header,
               const std::function<bool(std::string_view)>& read) {
  for (int number = 1; !bytes.empty(); ++number) {
    const std::size_t end = bytes.find('\n');
    if (end == std::string_view::npos) return;  // cut off while it was written
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    const std::string at = file + ":" + std::to_string(number) + ": ";
    if (number == 1 && line != header) {
      throw ResultsError(at + "expected the columns '" + header + "'");
    }
    if (number > 1 && !read(line)) throw ResultsError(at + "not a row of " + file);
  }
}

std::optional<std::pair<int, RunTiming>> TimingFromCsv(std::string_view line) {
  const auto cells = SplitCsv(line);
  if (!cells || cells->size() != 3) return std::nullopt;
  const auto run = NumberFromText((*cells)[0]);
  const auto cpu = NumberFromText((*cells)[1]), wall = NumberFromText((*cells)[2]);
  if (!run || !cpu || !wall || !(*run >= -1e9 && *run <= 1e9)) return std::nullopt;
  return std::pair{static_cast<int>(*run), RunTiming{*cpu, *wall}};
}

}  // namespace

std::string TimingHeader() { return "run,cpu_time_s,wall_time_s"; }

std::string TimingRow(int run, const RunTiming& timing) {
  return std::to_string(run) + "," + NumberText(timing.cpu_time_s) + "," +
         NumberText(timing.wall_time_s);
}

std::string ResultsCsv(const FinishedRuns& runs, const RowColumns& columns) {
  std::string csv = CsvHeader(columns) + "\n";
  for (const auto& [number, run] : runs) csv += CsvRow(run.result, columns) + "\n";
  return csv;
}

std::string TimingCsv(const FinishedRuns& runs) {
  std::string csv = TimingHeader() + "\n";
  for (const auto& [number, run] : runs) csv += TimingRow(number, run.timing) + "\n";
  return csv;
}

std::vector<RunResult> RowsFromCsv(std::string_view bytes, const std::string& file,
                                   const RowColumns& columns) {
  std::vector<RunResult> rows;
  ReadLines(bytes, file, CsvHeader(columns), [&](std::string_view line) {
    const auto row = RowFromCsv(line, columns);
    if (row) rows.push_back(*row);
    return row.has_value();
  });
  return rows;
}

FinishedRuns ReadResults(const std::filesystem::path& dir, const RowColumns& columns) {
  FinishedRuns runs;
  const auto results = ReadWhole(dir / "results.csv");
  if (!results) return runs;
  for (const RunResult& row : RowsFromCsv(*results, (dir / "results.csv").string(), columns)) {
    runs[row.run].result = row;
  }
  const std::filesystem::path timing_file = dir / "timing.csv";
  ReadLines(ReadWhole(timing_file).value_or(""), timing_file.string(), TimingHeader(),
            [&](std::string_view line) {
              const auto timing = TimingFromCsv(line);
              const auto run = timing ? runs.find(timing->first) : runs.end();
              if (run != runs.end()) run->second.timing = timing->second;
              return timing.has_value();
            });
  return runs;
}

}  // namespace dockyard
