// results.csv and timing.csv of a campaign's folder: written line by line as runs end, read back to
// continue after a stop, rewritten in run order at the end.
#pragma once

#include <filesystem>
#include <map>
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
  std::string note;  // what went wrong, for people; in outcome.json, not in the tables
};
/// By run number.
using FinishedRuns = std::map<int, FinishedRun>;

std::string TimingHeader();  // "run,cpu_time_s,wall_time_s"
std::string TimingRow(int run, const RunTiming& timing);

/// Whole files, in run order.
std::string ResultsCsv(const FinishedRuns& runs, const RowColumns& columns);
std::string TimingCsv(const FinishedRuns& runs);

/// Reads a folder's results.csv and timing.csv; without the files there are no runs. A last line
/// without its newline was cut off when the campaign stopped and is left out. Any other line that
/// is not a row throws ResultsError. Timings without a row are left out; notes are not read. Throws
/// IoError.
FinishedRuns ReadResults(const std::filesystem::path& dir, const RowColumns& columns);

/// Rows of results.csv's bytes; file is named in errors.
std::vector<RunResult> RowsFromCsv(std::string_view bytes, const std::string& file,
                                   const RowColumns& columns);

}  // namespace dockyard
