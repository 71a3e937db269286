#include "sim/app/reproduction_files.h"

#include <algorithm>
#include <cmath>

#include "sim/app/report_content.h"
#include "sim/app/scenario_options.h"
#include "sim/base/files.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/log/logged_run.h"
#include "sim/log/run_log.h"
#include "sim/plan/make_run.h"
#include "sim/report/points.h"
#include "sim/report/run_plots.h"
#include "sim/report/starts_plot.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

Pose2 PoseOf(const Json& json) { return {json.at("x_m"), json.at("y_m"), json.at("heading_rad")}; }

SightingError ErrorOf(const Json& sighting) {
  const Pose2 truth = PoseOf(sighting.at("true_X_DR"));
  const Pose2 measured = PoseOf(sighting.at("measured_X_DR"));
  const double r_m = std::hypot(truth.x, truth.y);
  return {.r_m = r_m,
          .r_error_m = std::hypot(measured.x, measured.y) - r_m,
          .place_error_m = std::hypot(measured.x - truth.x, measured.y - truth.y),
          .heading_error_rad = WrapPi(measured.heading - truth.heading),
          .method = sighting.at("method")};
}

/// The accepted sightings of a run whose folder is kept.
std::vector<SightingError> ErrorsOf(const fs::path& file, const std::string& text) {
  std::vector<SightingError> errors;
  try {
    for (const Json& sighting : Json::parse(text)) {
      if (sighting.at("accepted")) errors.push_back(ErrorOf(sighting));
    }
  } catch (const nlohmann::json::exception&) {
    throw ResultsError(file.string() + ": not the sightings of a run");
  }
  return errors;
}

CampaignResults ResultsOf(const PublishedCampaign& campaign, const fs::path& dir,
                          const std::vector<System>& systems) {
  if (!HoldsCampaign(dir)) return {};
  KeptCampaign kept = ReadKeptCampaign(dir, systems);
  const int replications = kept.campaign.repeats / RunsOfOne(campaign, systems);
  CampaignResults results{std::move(kept.runs.results), kept.columns, replications, {}};
  for (const RunResult& row : results.rows) {
    const Folder folder = dir;
    fs::path file = SightingsFile("", row.run);
    if (!folder.HasFile(file)) file = RunFolder("", row.run) / "sightings.json";
    if (const auto text = folder.Read(file, kMostSightingsBytes)) {
      results.sightings[row.run] = ErrorsOf(dir / file, *text);
    }
  }
  return results;
}

bool Reaches(const PublishedFigure& figure, const RunResult& row, const RowColumns& columns) {
  if (!figure.least_measure) return true;
  const std::vector<double> values = ValuesOf(columns, figure.least_measure->text, {&row});
  return !values.empty() && values[0] >= figure.least;
}

/// The first run of the figure that counts as a success; else the first one; null: none is kept.
const RunResult* RunFor(const PublishedFigure& figure, const Published& published,
                        const CampaignResults& results, const fs::path& dir) {
  const RunResult* first = nullptr;
  for (const RunResult& row : results.rows) {
    const bool shown = Matches(figure.where, row, results.columns) &&
                       Reaches(figure, row, results.columns) &&
                       Folder(dir).HasFile(RunFolder("", row.run) / kRunLogFile);
    if (!shown) continue;
    if (Counts(published, row)) return &row;
    if (first == nullptr) first = &row;
  }
  return first;
}

/// Those that the figure names, and the yaw.
std::vector<Column> ChannelsOf(const PublishedFigure& figure, const System& system) {
  std::vector<Column> channels;
  for (const Column& channel : system.columns.channels) {
    const auto named = [&](const PublishedName& name) { return name.text == channel.name; };
    if (figure.channels.empty() || channel.name == "yaw_deg" ||
        std::any_of(figure.channels.begin(), figure.channels.end(), named)) {
      channels.push_back(channel);
    }
  }
  return channels;
}

std::string WriteRunFigure(const PublishedFigure& figure, const Published& published,
                           const CampaignResults& results, const fs::path& dir,
                           const System& system, const fs::path& into) {
  const RunResult* row = RunFor(figure, published, results, dir);
  if (row == nullptr) return figure.file + ": missing: no run like it has kept its log";
  const LoggedRun run = ReadLoggedRun(Folder(dir).In(RunFolder("", row->run)));
  const std::string title =
      figure.title + ": run " + std::to_string(row->run) + ", " + row->outcome;
  const std::vector<Column> channels = ChannelsOf(figure, system);
  WriteWhole(into / (figure.file + "_path.svg"), PathPlot(title, run));
  WriteWhole(into / (figure.file + "_history.svg"), HistoryPlot(title, run, channels));
  return figure.file + "_path.svg, " + figure.file + "_history.svg: " + title;
}

/// With the publication's successes in place of the system's.
std::string WriteStarts(const PublishedFigure& figure, const Published& published,
                        std::vector<RunResult> rows, const std::vector<Pose2>& X_DR,
                        const fs::path& into) {
  if (X_DR.size() != rows.size()) return figure.file + ": missing: the starts are not known";
  for (RunResult& row : rows) row.docked = Counts(published, row);
  WriteWhole(into / (figure.file + ".svg"), StartsPlot(figure.title, rows, X_DR));
  return figure.file + ".svg: " + figure.title;
}

}  // namespace

CampaignNames NamesOf(const Campaign& campaign, const std::vector<System>& systems) {
  const std::vector<KnownSystem> known = KnownSystems(systems);
  const System& system = FindSystem(systems, RunMaker(campaign, known).Make(0).scenario.system);
  const RowColumns columns = system.Columns(campaign.labels);
  CampaignNames names{columns.labels, {}, CampaignSystemsOf(systems).measures(system.name), {}};
  for (const OutcomeName& outcome : columns.outcomes) names.outcomes.push_back(outcome.name);
  for (const Column& channel : system.columns.channels) names.channels.push_back(channel.name);
  return names;
}

int RunsOfOne(const PublishedCampaign& campaign, const std::vector<System>& systems) {
  return LoadCampaign(campaign.file, {}, CampaignSystemsOf(systems)).repeats;
}

std::vector<CampaignResults> ReadReproduced(const Published& published, const fs::path& dir,
                                            const std::vector<System>& systems) {
  std::vector<CampaignResults> all;
  for (const PublishedCampaign& campaign : published.campaigns) {
    all.push_back(ResultsOf(campaign, dir / campaign.name, systems));
  }
  return all;
}

std::vector<std::string> WriteFigures(const Published& published, const fs::path& dir,
                                      const Invocation& call) {
  const fs::path first = dir / published.campaigns.at(0).name, into = dir / "figures";
  if (published.figures.empty() || !HoldsCampaign(first)) return {};
  Folder(dir).Make("figures");
  ReportSource source;
  const ReportContent content = ContentOf(first, call, source);
  const System& system = FindSystem(call.systems, source.kept.system);
  const CampaignResults results{source.kept.runs.results, source.kept.columns, 1, {}};
  std::vector<std::string> lines;
  for (const PublishedFigure& figure : published.figures) {
    lines.push_back(figure.kind == PublishedFigure::Kind::kStarts
                        ? WriteStarts(figure, published, results.rows, content.starts, into)
                        : WriteRunFigure(figure, published, results, first, system, into));
  }
  return lines;
}

}  // namespace dockyard
