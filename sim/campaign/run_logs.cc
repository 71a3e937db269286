#include "sim/campaign/run_logs.h"

#include <utility>

#include "sim/campaign/campaign_folder.h"
#include "sim/log/run_log.h"
#include "sim/run/loop.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

}  // namespace

std::int64_t NumberOf(const Pass& pass) { return pass.again ? ~pass.index : pass.index; }

Pass PassOf(std::int64_t number) { return number < 0 ? Pass{~number, true} : Pass{number, false}; }

RunLogging LoggingOf(const CampaignRun& run, const Keep& keep, bool again, const fs::path& work_dir,
                     const Folder& results) {
  const bool of_program = !run.scenario.command.empty();
  const bool whole = again || StaysIfSuccess(keep, run.run);
  RunLogging logging;
  if (whole || of_program) logging.dir = work_dir;
  logging.images = whole && keep.pictures;
  logging.commands_alone = !whole;
  if (again && of_program) logging.recorded = results.In(CommandsFolder("", run.run));
  return logging;
}

RunLogs::RunLogs(const Keep& keep, const Folder& results, const RowColumns& columns)
    : keep_(keep), results_(results), columns_(columns), retention_(keep) {}

bool RunLogs::Chosen(const RunResult& result) {
  const Retention::Choice choice = retention_.Choose(result);
  if (choice.drop) Drop(*choice.drop);
  if (choice.keep && StartsProgram(result)) of_programs_.insert(result.run);
  return choice.keep;
}

void RunLogs::AddEarlier(std::int64_t index, const RunResult& result) {
  if (!Chosen(result) || results_.HasFolder(RunFolder("", result.run))) return;
  // A program's run cannot be made again without all of its commands.
  const fs::path commands = CommandsFolder("", result.run);
  const bool whole = !IsLost(result.outcome) && results_.HasFile(commands / kRunLogFile);
  if (StartsProgram(result) && !whole) return;
  to_simulate_.insert(index);
  waiting_[index] = {result, {}, {}};
}

std::optional<std::int64_t> RunLogs::NextAgain() {
  if (to_simulate_.empty()) return std::nullopt;
  const std::int64_t index = *to_simulate_.begin();
  to_simulate_.erase(to_simulate_.begin());
  return index;
}

void RunLogs::TakeRow(std::int64_t index, const FinishedRun& run, const fs::path& work) {
  const RunResult& row = run.result;
  if (keep_.sightings && !IsLost(row.outcome)) KeepSightings(run, work);
  const bool stays = Chosen(row);
  const bool cut_short = StartsProgram(row) && IsLost(row.outcome);
  if (stays && (cut_short || StaysIfSuccess(keep_, row.run))) return KeepWhole(run, work);
  results_.Remove(RunFolder("", row.run));  // of a former try that was lost
  if (StartsProgram(row)) KeepCommands(row.run, work);
  if (!stays) return;
  to_simulate_.insert(index);
  waiting_[index] = run;
}

void RunLogs::TakeLog(std::int64_t index, const FinishedRun& run, const fs::path& work) {
  const auto first = waiting_.find(index);
  if (first == waiting_.end()) return;  // its place was taken by a run of a lower number
  const FinishedRun of_row = std::move(first->second);
  waiting_.erase(first);
  const RunResult& row = of_row.result;
  if (IsLost(row.outcome)) return KeepWhole(of_row, work);
  const bool lost = IsLost(run.result.outcome);
  std::vector<DifferingCell> cells;
  if (!lost) cells = DifferingCells(row, run.result, columns_);
  if (lost || !cells.empty()) not_repeated_.push_back({row.run, cells});
  if (lost) return;  // made up when the campaign goes on
  // A program did not run a second time: what it printed is of the first.
  const fs::path commands = CommandsFolder("", row.run);
  if (StartsProgram(row) && results_.HasFile(commands / kMessagesFile)) {
    results_.Rename(commands / kMessagesFile, work / kMessagesFile);
  }
  KeepWhole(run, work);
  results_.Remove(commands);
}

void RunLogs::Move(const fs::path& from, const fs::path& to) const {
  results_.Make(to.parent_path());
  results_.Remove(to);
  results_.Rename(from, to);
}

void RunLogs::KeepCommands(int run, const fs::path& from) const {
  const fs::path folder = CommandsFolder("", run);
  for (const char* file : {kRunLogFile, kMessagesFile}) {
    std::error_code error;
    if (!results_.HasFile(from / file) ||
        fs::file_size(results_.path() / from / file, error) == 0) {
      continue;
    }
    results_.Make(folder);
    results_.Rename(from / file, folder / file);
  }
}

void RunLogs::KeepWhole(const FinishedRun& run, const fs::path& work) const {
  const fs::path folder = results_.path() / work;
  if (IsLost(run.result.outcome)) WriteLostRun(folder, run, columns_);
  std::error_code error;
  const fs::path messages = folder / kMessagesFile;
  if (fs::file_size(messages, error) == 0) fs::remove(messages, error);
  Move(work, RunFolder("", run.result.run));
}

void RunLogs::KeepSightings(const FinishedRun& run, const fs::path& work) const {
  const fs::path to = SightingsFile("", run.result.run);
  results_.Make(to.parent_path());
  results_.Write(to, results_.Read(work / "sightings.json", kMostSightingsBytes).value_or("[]\n"));
}

void RunLogs::Drop(int run) {
  for (auto waiting = waiting_.begin(); waiting != waiting_.end(); ++waiting) {
    if (waiting->second.result.run != run) continue;
    to_simulate_.erase(waiting->first);
    waiting_.erase(waiting);
    return;
  }
  const fs::path folder = RunFolder("", run);
  if (of_programs_.erase(run) > 0) KeepCommands(run, folder);
  results_.Remove(folder);
}

}  // namespace dockyard
