#include "sim/app/report_content.h"

#include <algorithm>
#include <optional>

#include "controller/base/number_text.h"
#include "sim/app/commands.h"
#include "sim/base/files.h"
#include "sim/base/shell_word.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// The run's start pose from its labels; none where they do not tell all of it.
std::optional<Pose2> StartFromLabels(const RunResult& row, const RowColumns& columns,
                                     const DockingCoords& base) {
  DockingCoords start = base;
  const auto take = [&](const char* label, double& value, bool degrees) {
    const auto at = std::find(columns.labels.begin(), columns.labels.end(), label);
    if (at == columns.labels.end()) return true;
    const auto number =
        NumberFromText(row.labels[static_cast<std::size_t>(at - columns.labels.begin())]);
    if (number) value = degrees ? Radians(*number) : *number;
    return number.has_value();
  };
  const bool told = take("start.r_m", start.r, false) &&
                    take("start.alpha_deg", start.alpha, true) &&
                    take("start.heading_deg", start.h, true);
  return told ? std::optional(FromDockingCoords(start)) : std::nullopt;
}

WatchedRun Watched(std::size_t place, const fs::path& dir, std::string command) {
  return {.place = place,
          .log = [dir] { return ReadLoggedRun(dir); },
          .shapes = {},
          .command = std::move(command),
          .messages = ReadWhole(dir / "messages.txt").value_or("")};
}

void AddSystem(const System& system, ReportContent& content) {
  content.system = system.name;
  content.channels = system.channels;
  content.beliefs = system.beliefs;
  content.program = "dockyard " DOCKYARD_VERSION;
}

StageShapes ShapesOf(const System& system, const Scenario& scenario) {
  return system.shapes ? system.shapes(scenario) : StageShapes{};
}

/// The runs whose log is kept, failures first.
void AddWatched(const fs::path& dir, const System& system, const ReportSource& source,
                ReportContent& content) {
  const std::vector<RunResult>& rows = source.kept.runs.results;
  const RunMaker* maker = source.maker.get();
  if (!fs::exists(dir / "runs")) return;
  for (const bool docked : {false, true}) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const int number = rows[i].run;
      const fs::path folder = RunFolder(dir, number);
      if (rows[i].docked != docked || !fs::exists(folder / kRunLogFile)) continue;
      WatchedRun run = Watched(
          i, folder, "dockyard replay " + ShellWord(dir.string()) + " " + std::to_string(number));
      run.shapes = [&system, maker, number] {
        return ShapesOf(system, maker->Make(maker->IndexOf(number)).scenario);
      };
      content.watched.push_back(std::move(run));
    }
  }
}

ReportContent ContentOfCampaign(const fs::path& dir, const std::vector<System>& systems,
                                ReportSource& source) {
  source.kept = ReadKeptCampaign(dir, systems);
  source.known = KnownSystems(systems);
  source.maker = std::make_unique<RunMaker>(source.kept.campaign, source.known);
  const System& system = FindSystem(systems, source.kept.system);
  ReportContent content;
  content.title = source.kept.campaign.name;
  content.campaign = &source.kept.campaign;
  content.runs = &source.kept.runs;
  content.columns = source.kept.columns;
  content.replay_command = "dockyard replay " + ShellWord(dir.string()) + " {run}";
  AddSystem(system, content);
  const DockingCoords base = source.maker->Make(0).scenario.start;
  const auto start = [&source, base](std::size_t place) {
    return StartFromLabels(source.kept.runs.results[place], source.kept.columns, base);
  };
  const std::size_t count = source.kept.runs.size();
  bool told = true;
  for (std::size_t i = 0; told && i < count; ++i) told = start(i).has_value();
  if (told && count > 0) content.start = [start](std::size_t place) { return *start(place); };
  AddWatched(dir, system, source, content);
  return content;
}

}  // namespace

ReportContent ContentOf(const fs::path& dir, const std::vector<System>& systems,
                        ReportSource& source) {
  if (HoldsCampaign(dir)) return ContentOfCampaign(dir, systems, source);
  if (!fs::exists(dir / "resolved.yaml")) {
    throw UsageError(
        "DIR: expected the results folder of a campaign or of one run, found none in '" +
        dir.string() + "'");
  }
  const Scenario scenario =
      LoadScenario((dir / "resolved.yaml").string(), {}, KnownSystems(systems));
  const System& system = FindSystem(systems, scenario.system);
  const auto row = ReadSingleResult(dir, system.Columns({}));
  if (!row) throw ResultsError(dir.string() + " has no result of its run");
  return ContentOfRun(dir, system, scenario, *row, source);
}

ReportContent ContentOfRun(const fs::path& dir, const System& system, const Scenario& scenario,
                           const RunResult& row, ReportSource& source) {
  source.scenario = std::make_shared<Scenario>(scenario);
  source.kept.runs = {};
  source.kept.runs.results.push_back(row);
  ReportContent content;
  content.title = scenario.name;
  content.runs = &source.kept.runs;
  content.columns = system.Columns({});
  AddSystem(system, content);
  content.start = [start = scenario.start](std::size_t) { return FromDockingCoords(start); };
  WatchedRun run = Watched(0, dir, "dockyard replay " + ShellWord(dir.string()));
  run.shapes = [&system, kept = source.scenario] { return ShapesOf(system, *kept); };
  content.watched.push_back(std::move(run));
  return content;
}

}  // namespace dockyard
