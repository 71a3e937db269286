#include "sim/campaign/worker.h"

#include <cstdio>
#include <sstream>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "sim/base/files.h"
#include "sim/base/text.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"
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

FinishedRun Crashed(const CampaignRun& run, const RowColumns& columns,
                    const std::filesystem::path& run_dir, const std::string& note,
                    const Child::End& child) {
  RunRecord record;
  record.columns = columns;
  record.result = StartOfRow(run);
  record.result.outcome = kCrashed;
  record.failure_note = note;
  if (!run_dir.empty()) WriteRecordFiles(run_dir, record);
  return {record.result, {child.cpu_time_s, child.wall_time_s}, note};
}

}  // namespace

void WriteFigures(const std::filesystem::path& dir, const std::vector<Figure>& figures) {
  for (const Figure& figure : figures) WriteWhole(dir / figure.file, figure.text);
}

std::string RunAndAnswer(const CampaignRun& run, const RunWork& work,
                         const std::filesystem::path& run_dir) {
  try {
    const RunRecord record = work.simulate(run, run_dir);
    if (!run_dir.empty()) WriteRecordFiles(run_dir, record);
    if (!record.messages.empty()) std::fputs(record.messages.c_str(), stderr);  // messages.txt
    if (work.draw && !run_dir.empty()) WriteFigures(run_dir, work.draw(record, run.scenario));
    return Answer(kRow, CsvRow(record.result, work.columns)) +
           NumberText(record.timing.cpu_time_s) + "\n" + NumberText(record.timing.wall_time_s) +
           "\n" + OneLine(record.failure_note) + "\n";
  } catch (const IoError& error) {
    return Answer(kIoError, error.what());
  } catch (const ConfigError& error) {
    return Answer(kConfigError, error.what());
  } catch (const std::exception& error) {
    return Answer(kThrew, error.what());
  }
}

FinishedRun ReadAnswer(const CampaignRun& run, const RowColumns& columns,
                       const std::filesystem::path& run_dir, const Child::End& child) {
  if (!child.how_it_died.empty()) {
    return Crashed(run, columns, run_dir, child.how_it_died, child);
  }
  std::istringstream lines(child.answer);
  std::string kind, text, cpu, wall, note;
  for (std::string* line : {&kind, &text, &cpu, &wall, &note}) std::getline(lines, *line);
  if (kind == kIoError) throw IoError(text);
  if (kind == kConfigError) throw ConfigError(text);
  if (kind == kThrew) return Crashed(run, columns, run_dir, "threw: " + text, child);
  const auto row = RowFromCsv(text, columns);
  const auto cpu_s = NumberFromText(cpu), wall_s = NumberFromText(wall);
  DOCKYARD_CHECK(kind == kRow && row && row->run == run.run && cpu_s && wall_s);
  return {*row, {*cpu_s, *wall_s}, row->docked ? "" : note};
}

}  // namespace dockyard
