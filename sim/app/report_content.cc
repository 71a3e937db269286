#include "sim/app/report_content.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "controller/base/number_text.h"
#include "sim/app/all_images.h"
#include "sim/app/kept_run.h"
#include "sim/app/scenario_options.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/log/record_files.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStart = "start.";

bool SetsStart(const std::string& key) { return key == "start" || key.starts_with(kStart); }

/// Whether the start pose of a run follows from its labels alone.
bool LabelsTellStart(const Campaign& campaign) {
  const auto untold = [](const YamlNode::Key& key) { return key.name == "start"; };
  const std::vector<YamlNode::Key> keys = KeysOfRuns(campaign);
  bool told = std::none_of(keys.begin(), keys.end(), untold);
  for (const Arm& arm : campaign.arms) {
    for (const KeyValue& set : arm.sets) told = told && !SetsStart(set.key.name);
  }
  for (const Factor& factor : campaign.one_at_a_time) told = told && !SetsStart(factor.key.name);
  return told;
}

/// Empty where a label is no number.
std::vector<Pose2> StartsFromLabels(const std::vector<RunResult>& rows, const RowColumns& columns,
                                    const Start& base) {
  std::vector<Pose2> poses;
  for (const RunResult& row : rows) {
    Start start = base;
    for (std::size_t i = 0; i < columns.labels.size(); ++i) {
      const std::string& label = columns.labels[i];
      if (!label.starts_with(kStart)) continue;
      const auto number = NumberFromText(row.labels[i]);
      if (!number || !start.SetInFile(label.substr(kStart.size()), *number)) return {};
    }
    poses.push_back(start.pose());
  }
  return poses;
}

/// From the labels, else from the runs made again, which takes 0.1 ms each.
std::vector<Pose2> StartsOf(const ReportSource& source) {
  constexpr std::size_t kMostMade = 20'000;
  const std::vector<RunResult>& rows = source.kept.runs.results;
  std::vector<Pose2> starts;
  if (LabelsTellStart(source.kept.campaign)) {
    starts = StartsFromLabels(rows, source.kept.columns, source.maker->Make(0).scenario.start);
  }
  if (!starts.empty() || rows.size() > kMostMade) return starts;
  for (const RunResult& row : rows) {
    starts.push_back(source.maker->Make(source.maker->IndexOf(row.run)).scenario.start.pose());
  }
  return starts;
}

WatchedRun Watched(std::size_t place, const Folder& dir, std::string command) {
  return {.place = place,
          .log = [dir] { return ReadLoggedRun(dir); },
          .shapes = {},
          .command = std::move(command),
          .messages = dir.Read(kMessagesFile, kMostMessagesBytes).value_or("")};
}

void AddSystem(const System& system, ReportContent& content) {
  content.system = system.name;
  content.channels = system.columns.channels;
  content.beliefs = system.columns.beliefs;
  content.program = "dockyard " DOCKYARD_VERSION;
}

StageShapes ShapesOf(const System& system, const Scenario& scenario) {
  return system.shapes ? system.shapes(scenario) : StageShapes{};
}

/// The runs whose log is kept, failures first.
void AddWatched(const fs::path& dir, const System& system, const ReportSource& source,
                const Invocation& call, ReportContent& content) {
  const std::vector<RunResult>& rows = source.kept.runs.results;
  const RunMaker* maker = source.maker.get();
  if (!Folder(dir).HasFolder("runs")) return;
  const ReplayOptions options = KeptReplayOptions(dir, call.secret_file);
  for (const bool success : {false, true}) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const int number = rows[i].run;
      const Folder folder = Folder(dir).In(RunFolder("", number));
      if (rows[i].success != success || !folder.HasFile(kRunLogFile)) continue;
      WatchedRun run = Watched(i, folder,
                               ReplayCommand(call.program, dir, std::to_string(number),
                                             StartsProgram(rows[i]), options));
      run.shapes = [&system, maker, number] {
        return ShapesOf(system, maker->Make(maker->IndexOf(number)).scenario);
      };
      content.watched.push_back(std::move(run));
    }
  }
}

ReportContent ContentOfCampaign(const fs::path& dir, const Invocation& call, ReportSource& source) {
  const std::vector<System>& systems = call.systems;
  source.kept = ReadKeptCampaign(dir, systems, call.secret_file);
  source.known = KnownSystems(systems);
  source.maker = std::make_unique<RunMaker>(source.kept.campaign, source.known);
  const System& system = FindSystem(systems, source.kept.system);
  ReportContent content;
  content.title = source.kept.campaign.name;
  content.campaign = &source.kept.campaign;
  content.runs = &source.kept.runs;
  content.columns = source.kept.columns;
  const std::vector<RunResult>& rows = source.kept.runs.results;
  content.replay_command = ReplayCommand(call.program, dir, "{run}",
                                         std::any_of(rows.begin(), rows.end(), StartsProgram),
                                         KeptReplayOptions(dir, call.secret_file));
  AddSystem(system, content);
  content.starts = StartsOf(source);
  AddWatched(dir, system, source, call, content);
  return content;
}

}  // namespace

ReportContent ContentOf(const fs::path& dir, const Invocation& call, ReportSource& source) {
  const std::vector<System>& systems = call.systems;
  if (HoldsCampaign(dir)) return ContentOfCampaign(dir, call, source);
  if (!HoldsRun(dir)) RefuseResultsFolder(dir, kAnyResults);
  const Scenario scenario =
      LoadScenario((dir / "resolved.yaml").string(), {}, KnownSystems(systems));
  const System& system = FindSystem(systems, scenario.system);
  const auto row = ReadSingleResult(dir, system.Columns({}));
  if (!row) throw ResultsError(dir.string() + " has no result of its run");
  return ContentOfRun(dir, system, scenario, *row,
                      ReplayCommand(call.program, dir, "", StartsProgram(*row), ReplayOptions{}),
                      source);
}

void MakeAllImages(const ReportSource& source, const Invocation& call, ReportContent& content) {
  // The page reads a log while it packs another one; two simulations would not be quicker.
  const auto one_at_a_time = std::make_shared<std::mutex>();
  for (WatchedRun& watched : content.watched) {
    const int number = content.runs->results[watched.place].run;
    watched.log = [read = watched.log, number, one_at_a_time, labels = content.columns.labels,
                   &source, &call] {
      const std::lock_guard<std::mutex> lock(*one_at_a_time);
      CampaignRun run = source.maker == nullptr ? SingleRun(*source.scenario)
                                                : source.maker->Make(source.maker->IndexOf(number));
      return WithAllImages(read(), std::move(run), labels, call);
    };
  }
}

void WriteReport(const fs::path& dir, const fs::path& file, const Invocation& call,
                 const std::vector<Requirement>& requirements) {
  ReportSource source;
  ReportContent content = ContentOf(dir, call, source);
  content.requirements = requirements;
  if (file.has_parent_path()) MakeFolder(file.parent_path());
  WriteWhole(file, ReportPage(content));
  PrintNote("report in " + file.string());
}

ReportContent ContentOfRun(const fs::path& dir, const System& system, const Scenario& scenario,
                           const RunResult& row, std::string replay_command, ReportSource& source) {
  source.scenario = std::make_shared<Scenario>(scenario);
  source.kept.runs = {};
  source.kept.runs.results.push_back(row);
  ReportContent content;
  content.title = scenario.name;
  content.runs = &source.kept.runs;
  content.columns = system.Columns({});
  AddSystem(system, content);
  content.starts = {scenario.start.pose()};
  WatchedRun run = Watched(0, dir, std::move(replay_command));
  run.shapes = [&system, kept = source.scenario] { return ShapesOf(system, *kept); };
  content.watched.push_back(std::move(run));
  return content;
}

}  // namespace dockyard
