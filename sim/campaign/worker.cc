#include "sim/campaign/worker.h"

#include <sstream>

#include "controller/base/check.h"
#include "models/config_error.h"
#include "sim/campaign/run_plots.h"
#include "sim/log/files.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

// The answer is lines of text: a kind, then what belongs to it.
constexpr const char* kRow = "row";
constexpr const char* kIoError = "io_error";
constexpr const char* kInputError = "input_error";
constexpr const char* kThrew = "threw";

std::string Answer(const std::string& kind, const std::string& text) {
  return kind + "\n" + OneLine(text) + "\n";
}

std::string RunAndAnswer(const CampaignRun& run, const RunFunction& function,
                         const std::filesystem::path& run_dir) {
  try {
    const RunRecord record = function(run, run_dir);
    WriteRecordFiles(run_dir, record);
    WriteRunPlots(run_dir, record);
    return std::string(kRow) + "\n" + CsvRow(record.result) + "\n" +
           NumberText(record.timing.cpu_time_s) + " " + NumberText(record.timing.wall_time_s) +
           "\n";
  } catch (const IoError& error) {
    return Answer(kIoError, error.what());
  } catch (const InputError& error) {
    return Answer(kInputError, error.what());
  } catch (const std::exception& error) {
    return Answer(kThrew, error.what());
  }
}

}  // namespace

Worker::Worker(const CampaignRun& run, const RunFunction& function,
               const std::filesystem::path& run_dir, double time_limit_s,
               const std::vector<int>& close_in_child)
    : run_(run),
      run_dir_(run_dir),
      child_([&] { return RunAndAnswer(run, function, run_dir); }, run_dir / "messages.txt",
             time_limit_s, close_in_child) {}

WorkerEnd Worker::Crashed(const std::string& note, const Child::End& child) const {
  WorkerEnd end;
  end.crashed = true;
  end.note = note;
  end.run.result = StartOfRow(run_);
  end.run.result.outcome = Outcome::kCrashed;
  end.run.timing = {child.cpu_time_s, child.wall_time_s};
  RunRecord record;
  record.result = end.run.result;
  record.failure_note = note;
  WriteRecordFiles(run_dir_, record);
  return end;
}

WorkerEnd Worker::Finish() {
  const Child::End child = child_.Finish();
  if (!child.how_it_died.empty()) return Crashed(child.how_it_died, child);
  std::istringstream lines(child.answer);
  std::string kind, text, timing;
  std::getline(lines, kind);
  std::getline(lines, text);
  std::getline(lines, timing);
  if (kind == kIoError) throw IoError(text);
  if (kind == kInputError) throw InputError(text);
  if (kind == kThrew) return Crashed("threw: " + text, child);
  const auto row = RowFromCsv(text);
  DOCKYARD_CHECK(kind == kRow && row.has_value() && row->run == run_.run);
  WorkerEnd good;
  good.run.result = *row;
  const std::size_t space = timing.find(' ');
  good.run.timing.cpu_time_s = NumberFromText(timing.substr(0, space)).value_or(0.0);
  good.run.timing.wall_time_s = NumberFromText(timing.substr(space + 1)).value_or(0.0);
  return good;
}

}  // namespace dockyard
