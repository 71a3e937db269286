#include "sim/campaign/campaign_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>

#include "sim/base/json.h"
#include "sim/campaign/database.h"
#include "sim/campaign/worker.h"
#include "sim/log/result_row.h"
#include "sim/report/points.h"
#include "sim/report/summary.h"

namespace dockyard {
namespace {

bool HoldsOnlyScraps(const std::filesystem::path& dir) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(dir, error)) {
    const std::string name = entry.path().filename().string();
    if (name != ".lock" && name != "identity.txt" && entry.path().extension() != ".tmp") {
      return false;
    }
  }
  if (error) throw IoError("cannot read folder " + dir.string() + ": " + error.message());
  return true;
}

std::string FailureNote(const std::filesystem::path& run_dir) {
  const auto text = ReadWhole(run_dir / "outcome.json");
  if (!text) return "";
  const Json json = Json::parse(*text, nullptr, /*allow_exceptions=*/false);
  const bool has_note = json.is_object() && json.contains("failure_note");
  return has_note && json["failure_note"].is_string() ? json["failure_note"].get<std::string>()
                                                      : "";
}

}  // namespace

std::filesystem::path RunFolder(const std::filesystem::path& dir, int run) {
  char name[32];
  std::snprintf(name, sizeof name, "%03d", run);
  return dir / "runs" / name;
}

CampaignFolder::CampaignFolder(const std::filesystem::path& dir, const Campaign& campaign,
                               const RunMaker& maker, const FolderIdentity& identity)
    : dir_(dir), columns_(identity.columns) {
  MakeFolder(dir_);
  Lock();
  try {
    Claim(identity);
    if (campaign.keep == Keep::kAll) MakeFolder(dir_ / "runs");
    MakeFolder(dir_ / "plots");
    finished_ = ReadResults(dir_, columns_);
    CheckRows(maker);
    ReadNotes();
    // A line that was cut off goes, so that the next one starts on a line of its own.
    WriteWhole(dir_ / "timing.csv", TimingCsv(finished_));
    WriteWhole(dir_ / "results.csv", ResultsCsv(finished_, columns_));
    results_ = std::make_unique<LineAppender>(dir_ / "results.csv");
    timing_ = std::make_unique<LineAppender>(dir_ / "timing.csv");
  } catch (...) {
    ::close(lock_);
    throw;
  }
}

CampaignFolder::~CampaignFolder() { ::close(lock_); }

void CampaignFolder::Lock() {
  const std::filesystem::path path = dir_ / ".lock";
  lock_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (lock_ < 0) throw IoErrorFromErrno("write", path);
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(lock_);
    throw FolderTaken("another campaign is running in " + dir_.string());
  }
}

void CampaignFolder::Claim(const FolderIdentity& of) {
  const std::string other = "; choose another folder with --out, or remove it";
  const auto resolved = ReadWhole(dir_ / "resolved.yaml");
  if (!resolved) {
    if (!HoldsOnlyScraps(dir_)) {
      throw FolderTaken(dir_.string() + " is not empty and holds no campaign" + other);
    }
    WriteWhole(dir_ / "identity.txt", of.identity);
    WriteWhole(dir_ / "resolved.yaml", of.resolved_yaml);
    return;
  }
  if (*resolved != of.resolved_yaml) {
    throw FolderTaken(dir_.string() + " holds another campaign (its resolved.yaml differs)" +
                      other);
  }
  if (ReadWhole(dir_ / "identity.txt").value_or("") != of.identity && !of.identity.empty()) {
    throw FolderTaken(
        dir_.string() +
        " was begun with another build of the program, or with other files of models or "
        "controllers (its identity.txt differs)" +
        other);
  }
}

void CampaignFolder::CheckRows(const RunMaker& maker) const {
  for (const auto& [number, run] : finished_) {
    const std::int64_t index = maker.IndexOf(number);
    if (index < 0 || maker.Seed(index) != run.result.seed) {
      throw ResultsError((dir_ / "results.csv").string() + ": run " + std::to_string(number) +
                         " does not belong to this campaign");
    }
  }
}

void CampaignFolder::ReadNotes() {
  for (auto& [number, run] : finished_) {
    if (!run.result.docked) run.note = FailureNote(RunFolder(dir_, number));
  }
}

std::filesystem::path CampaignFolder::StartRun(int run) const {
  const std::filesystem::path path = RunFolder(dir_, run);
  std::error_code error;
  std::filesystem::remove_all(path, error);
  if (error) throw IoError("cannot empty folder " + path.string() + ": " + error.message());
  MakeFolder(path);
  return path;
}

// The timing goes first: a run counts as done when its row is there.
void CampaignFolder::Keep(const FinishedRun& run) {
  timing_->Append(TimingRow(run.result.run, run.timing));
  results_->Append(CsvRow(run.result, columns_));
  finished_[run.result.run] = run;
}

std::string CampaignFolder::Conclude(const Campaign& campaign, const RunMaker& maker,
                                     const DrawCampaign& draw) const {
  std::vector<RunResult> rows;
  for (const auto& [number, run] : finished_) rows.push_back(run.result);
  WriteWhole(dir_ / "timing.csv", TimingCsv(finished_));
  WriteWhole(dir_ / "results.csv", ResultsCsv(finished_, columns_));
  WriteDatabase(dir_ / "results.sqlite", finished_, columns_);
  if (draw) {
    WriteFigures(dir_ / "plots", draw(campaign.name, maker.Make(0).scenario, columns_, rows));
  }
  WritePoints(campaign, rows);
  const std::string summary = SummaryText(campaign.name, finished_, columns_, campaign.run_count());
  WriteWhole(dir_ / "summary.txt", summary);
  return summary;
}

void CampaignFolder::WritePoints(const Campaign& campaign,
                                 const std::vector<RunResult>& rows) const {
  const std::vector<std::string> settings = campaign.settings();
  const std::vector<std::string>& measures = campaign.figures.measures;
  if (!settings.empty()) {
    WriteWhole(dir_ / "points.csv", PointsCsv(settings, columns_, rows));
    WriteWhole(dir_ / "points.md", PointsTable(settings, measures, columns_, rows));
  }
  std::vector<Figure> figures{
      {"curves.svg", CurvesPlot(campaign.name, campaign.figures, columns_, rows)},
      {"bars.svg", BarsPlot(campaign.name, measures, columns_, rows)}};
  figures.erase(std::remove_if(figures.begin(), figures.end(),
                               [](const Figure& figure) { return figure.text.empty(); }),
                figures.end());
  WriteFigures(dir_ / "plots", figures);
}

}  // namespace dockyard
