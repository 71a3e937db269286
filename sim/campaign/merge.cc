#include "sim/campaign/merge.h"

#include <algorithm>
#include <memory>

#include "sim/base/folder.h"
#include "sim/base/json.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/database.h"
#include "sim/campaign/run_work.h"
#include "sim/campaign/shard_file.h"
#include "sim/log/result_row.h"
#include "sim/mcap/mcap_reader.h"
#include "sim/report/points.h"
#include "sim/report/sensitivity.h"
#include "sim/report/summary.h"
#include "sim/report/until_accepted.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// A row and the file that it stands in.
struct Candidate {
  int run = 0;
  std::uint32_t file = 0;
  bool lost = false, former = false;
  std::string_view text;
};

FinishedRun Parsed(const Candidate& row, const fs::path& file, const RowColumns& columns) {
  auto run = RowFromShard(row.text, row.former ? FormerColumns(columns) : columns);
  if (!run) {
    throw ResultsError(file.string() + ": run " + std::to_string(row.run) + ": not a row");
  }
  return std::move(*run);
}

[[noreturn]] void RefuseDifferent(const FinishedRun& a, const FinishedRun& b,
                                  const fs::path& file_a, const fs::path& file_b,
                                  const RowColumns& columns) {
  std::string differing;
  for (const DifferingCell& cell : DifferingCells(a.result, b.result, columns)) {
    differing += (differing.empty() ? "" : ", ") + cell.column;
  }
  throw ResultsError("run " + std::to_string(a.result.run) + " has two results, in " +
                     file_a.string() + " and " + file_b.string() + ", which differ in " +
                     differing +
                     ": were they made on computers with different mathematics (dockyard doctor)?");
}

/// The result among the rows of one run, else the last.
FinishedRun Chosen(const Candidate* first, const Candidate* last,
                   const std::vector<fs::path>& files, const RowColumns& columns) {
  const Candidate* result =
      std::find_if(first, last, [](const Candidate& each) { return !each.lost; });
  if (result == last) return Parsed(*(last - 1), files[(last - 1)->file], columns);
  FinishedRun chosen = Parsed(*result, files[result->file], columns);
  for (const Candidate* other = result + 1; other != last; ++other) {
    if (other->lost || other->text == result->text) continue;
    const FinishedRun again = Parsed(*other, files[other->file], columns);
    if (!DifferingCells(chosen.result, again.result, columns).empty()) {
      RefuseDifferent(chosen, again, files[result->file], files[other->file], columns);
    }
  }
  return chosen;
}

/// The first lines of the shard files: where the rows were made.
Json ShardHeaders(const fs::path& dir, const RowColumns& columns) {
  Json headers = Json::object();
  for (const fs::path& path : ShardFiles(dir)) {
    headers[path.stem().string()] = ShardReader(path, columns).header();
  }
  return headers;
}

void WriteManifest(const fs::path& dir, const RowColumns& columns) {
  Json manifest = ReadManifest(dir);
  if (manifest.empty()) throw ResultsError((dir / "manifest.json").string() + ": not JSON");
  manifest["shards"] = ShardHeaders(dir, columns);
  WriteWhole(dir / "manifest.json", manifest.dump(2) + "\n");
}

void WritePoints(const fs::path& dir, const Campaign& campaign, const RowColumns& columns,
                 const std::vector<RunResult>& rows) {
  const std::vector<std::string> settings = campaign.settings();
  const std::vector<std::string>& measures = campaign.figures.measures;
  if (!settings.empty()) {
    WriteWhole(dir / "points.csv", PointsCsv(settings, columns, rows));
    WriteWhole(dir / "points.md", PointsTable(settings, measures, columns, rows));
  }
  const auto write = [&](const char* file, const std::string& figure) {
    if (!figure.empty()) Folder(dir).Write(fs::path("plots") / file, figure);
  };
  write("curves.svg", CurvesPlot(campaign.name, campaign.figures, columns, rows));
  write("bars.svg", BarsPlot(campaign.name, measures, columns, rows));
}

/// Tables and figure of a campaign with draws; returns its part of the summary.
std::string WriteSensitivity(const fs::path& dir, const Campaign& campaign,
                             const RowColumns& columns, const std::vector<RunResult>& rows) {
  const std::vector<Sensitivity> found = FindSensitivity(campaign, columns, rows);
  if (found.empty()) return "";
  WriteWhole(dir / "sensitivity.csv", SensitivityCsv(found));
  WriteWhole(dir / "sensitivity_levels.csv", SensitivityLevelsCsv(found));
  const std::string plot = SensitivityPlot(campaign.name, found);
  if (!plot.empty()) Folder(dir).Write("plots/sensitivity.svg", plot);
  return SensitivityText(found);
}

bool OneContinuesTheOther(const std::string& a, const std::string& b) {
  return a.starts_with(b) || b.starts_with(a);
}

}  // namespace

FinishedRuns ReadShards(const fs::path& dir, const RowCheck& check, const RowColumns& columns,
                        std::vector<std::string>* damaged) {
  const std::vector<fs::path> files = ShardFiles(dir);
  std::vector<std::unique_ptr<ShardReader>> shards;
  std::vector<Candidate> rows;
  for (std::uint32_t i = 0; i < files.size(); ++i) {
    shards.push_back(std::make_unique<ShardReader>(files[i], columns));
    const std::vector<int> lines = shards.back()->ForEach([&](const RowPlace& row) {
      check.Require(row, files[i]);
      rows.push_back({row.run, i, IsLost(row.outcome), row.former, row.text});
    });
    if (damaged == nullptr) continue;
    for (const int line : lines) damaged->push_back(files[i].string() + ":" + std::to_string(line));
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Candidate& a, const Candidate& b) { return a.run < b.run; });
  FinishedRuns runs;
  const Candidate* end = rows.data() + rows.size();
  for (const Candidate* first = rows.data(); first != end;) {
    const Candidate* last = first;
    while (last != end && last->run == first->run) ++last;
    runs.Add(Chosen(first, last, files, columns));
    first = last;
  }
  return runs;
}

bool LeaveOutUncounted(const fs::path& dir, FinishedRuns& runs) {
  const int decided = DecidedRuns(Folder(dir).Read(kAcceptanceFile, kMostTextBytes).value_or(""));
  const auto counted = static_cast<std::size_t>(decided);
  // The test takes runs in their order, and they are numbered from 1 on.
  if (decided == 0 || runs.size() < counted) return false;
  runs.results.resize(counted);
  runs.timings.resize(counted);
  runs.notes.resize(counted);
  return true;
}

void TakeShards(const fs::path& from, const fs::path& into) {
  const Folder source = from, target = into;
  if (HoldsCampaign(from)) RequirePlain(from);
  if (HoldsCampaign(from) && !fs::exists(into)) {
    MakeFolder(into);
    for (const char* part : {"files", "manifest.json", "campaign.yaml"}) {
      source.CopyInto(target, part, kMostLogBytes);
    }
  }
  const auto manifest_of = [](const fs::path& dir) {
    if (!HoldsCampaign(dir)) throw FolderTaken(dir.string() + " holds no campaign");
    return ReadManifest(dir);
  };
  const std::string difference = ManifestDifference(manifest_of(from), manifest_of(into));
  if (!difference.empty()) {
    throw FolderTaken(from.string() + " does not belong to " + into.string() + ": " + difference);
  }
  for (const fs::path& path : ShardFiles(from)) {
    const fs::path place = into / "shards" / path.filename();
    const fs::path name = fs::path("shards") / path.filename();
    const std::string bytes = source.Read(name, kMostShardBytes).value_or("");
    const std::string there = target.Read(name, kMostShardBytes).value_or("");
    if (!OneContinuesTheOther(bytes, there)) {
      throw FolderTaken(path.string() + " and " + place.string() +
                        " are shards of the same name with different rows: were both folders run "
                        "with the same --shard?");
    }
    target.Make("shards");
    if (bytes.size() > there.size()) target.Write(name, bytes);
  }
  for (const char* part : {"runs", "commands", "sightings"})
    source.CopyInto(target, part, kMostLogBytes);
}

CampaignEnd MergeShards(const fs::path& dir, const Campaign& campaign, const RowColumns& columns) {
  const Descriptor alone = LockResults(dir);
  CampaignEnd end;
  end.total = campaign.run_count();
  end.runs = ReadShards(dir, RowCheck(campaign), columns, &end.damaged);
  const bool enough = LeaveOutUncounted(dir, end.runs);
  const std::vector<RunResult>& rows = end.runs.results;
  WriteManifest(dir, columns);
  WriteTimingCsv(dir / "timing.csv", end.runs);
  WriteResultsCsv(dir / "results.csv", end.runs, columns);
  WriteDatabase(dir / "results.sqlite", end.runs, columns);
  Folder(dir).Make("plots");
  WritePoints(dir, campaign, columns, rows);
  end.summary = SummaryText(campaign.name, end.runs, columns, end.total, enough) +
                WriteSensitivity(dir, campaign, columns, rows);
  WriteWhole(dir / "summary.txt", end.summary);
  return end;
}

}  // namespace dockyard
