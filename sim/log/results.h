// The results of many runs, and the tables that hold them: results.csv and timing.csv.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/log/record.h"

namespace dockyard {

/// A results folder with a wrong file. The message is a sentence with file and line.
class ResultsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct FinishedRun {
  RunResult result;
  RunTiming timing;
  std::string note;  // what went wrong, for people; not in the tables
};

/// In order of run numbers. The three lists run in parallel: there may be a million runs, and most
/// readers want the results alone.
struct FinishedRuns {
  std::vector<RunResult> results;
  std::vector<RunTiming> timings;
  std::vector<std::string> notes;

  /// The run's number must be above those before it.
  void Add(FinishedRun run);
  std::size_t size() const { return results.size(); }
  bool empty() const { return results.empty(); }
  /// The place of the run in the lists; size() if it is not there.
  std::size_t Find(int run) const;
};

/// What a success is called: the one success_word of all rows; without any, the system's only
/// outcome that is a success; else "succeeded".
std::string SuccessWord(const RowColumns& columns, const std::vector<RunResult>& rows = {});

/// The four numbers' names and texts, in one order.
std::vector<std::string> TimingNames();
std::vector<std::string> TimingCells(const RunTiming& timing);
/// None unless these are the four cells of a timing.
std::optional<RunTiming> TimingFromCells(const std::vector<std::string>& cells);
std::string TimingHeader();  // of timing.csv: run, and the names

/// Write whole files, in run order. Throw IoError.
void WriteResultsCsv(const std::filesystem::path& path, const FinishedRuns& runs,
                     const RowColumns& columns);
void WriteTimingCsv(const std::filesystem::path& path, const FinishedRuns& runs);

/// Rows of results.csv's bytes, also by former columns; file is named in errors. A last line
/// without its newline was cut off and is left out. Any other line that is not a row throws
/// ResultsError.
std::vector<RunResult> RowsFromCsv(std::string_view bytes, const std::string& file,
                                   const RowColumns& columns);

}  // namespace dockyard
