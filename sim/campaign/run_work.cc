#include "sim/campaign/run_work.h"

#include <cstdio>
#include <sstream>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "sim/base/files.h"
#include "sim/base/text.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"
#include "sim/log/run_log.h"
#include "sim/mcap/mcap_repair.h"
#include "sim/run/loop.h"

namespace dockyard {
namespace {

// The answer is lines of text: a kind, then the kind's content.
constexpr const char* kRow = "row";
constexpr const char* kIoError = "io_error";
constexpr const char* kConfigError = "config_error";
constexpr const char* kThrew = "threw";

std::string Answer(const std::string& kind, const std::string& text) {
  return kind + "\n" + OneLine(text) + "\n";
}

FinishedRun Lost(const CampaignRun& run, const std::string& outcome, const std::string& note,
                 const JobEnd& end) {
  FinishedRun lost{
      StartOfRow(run), {.cpu_time_s = end.cpu_time_s, .wall_time_s = end.wall_time_s}, note};
  lost.result.outcome = outcome;
  return lost;
}

}  // namespace

std::string RunAndAnswer(const RunWork& work) {
  try {
    const CampaignRun run = work.make();
    const RunLogging logging = work.logging(run);
    const RunRecord record = work.simulate(run, logging);
    if (!logging.dir.empty()) {
      WriteRecordFiles(logging.dir, record);
    } else if (work.sightings) {
      WriteSightings(work.dir, record);
    }
    if (!record.messages.empty()) std::fputs(record.messages.c_str(), stderr);  // messages.txt
    return Answer(kRow, CsvRow(record.result, work.columns)) + CsvLine(TimingCells(record.timing)) +
           "\n" + OneLine(record.failure_note) + "\n";
  } catch (const IoError& error) {
    return Answer(kIoError, error.what());
  } catch (const ConfigError& error) {
    return Answer(kConfigError, error.what());
  } catch (const std::exception& error) {
    return Answer(kThrew, error.what());
  }
}

FinishedRun ReadAnswer(const std::function<CampaignRun()>& make, const RowColumns& columns,
                       const JobEnd& end) {
  if (end.loss == Loss::kStopped) return Lost(make(), kStopped, end.how_it_died, end);
  if (end.loss == Loss::kCrashed) return Lost(make(), kCrashed, end.how_it_died, end);
  std::istringstream lines(end.answer);
  std::string kind, text, times, note;
  for (std::string* line : {&kind, &text, &times, &note}) std::getline(lines, *line);
  if (kind == kIoError) throw IoError(text);
  // The campaign was checked before: this run alone drew what cannot be simulated.
  if (kind == kConfigError) return Lost(make(), kCrashed, "refused: " + text, end);
  if (kind == kThrew) return Lost(make(), kCrashed, "threw: " + text, end);
  const auto row = RowFromCsv(text, columns);
  const auto timing = TimingFromCells(SplitCsv(times).value_or(std::vector<std::string>{}));
  DOCKYARD_CHECK(kind == kRow && row && timing);
  return {*row, *timing, row->success ? "" : note};
}

void WriteLostRun(const std::filesystem::path& run_dir, const FinishedRun& run,
                  const RowColumns& columns) {
  RunRecord record;
  record.columns = columns;
  record.result = run.result;
  record.failure_note = run.note;
  WriteRecordFiles(run_dir, record);
  const std::filesystem::path log = run_dir / kRunLogFile;
  if (!std::filesystem::exists(log)) return;
  try {
    RepairMcap(log);
  } catch (const DataError&) {  // cut in its first bytes: there is nothing to close
  }
}

}  // namespace dockyard
