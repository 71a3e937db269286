#include "support/fake_runs.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "sim/base/random.h"
#include "sim/base/text.h"

namespace dockyard {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "dockyard_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

RowColumns FakeColumns() {
  return {.labels = {"soil", "start.r_m"},
          .measures = {{"depth_m", "m", "of the point beyond its flag", true},
                       {"force_peak_n", "N", "on the flag"},
                       {"yaw_error_deg", "deg", "at the end"}},
          .outcomes = {{"docked", true, "it stands at its flag"},
                       {"missed", false, "it stands elsewhere"},
                       {"timeout", false, "it still drove"},
                       {kCrashed, false, "its process died"},
                       {kStopped, false, "its process was ended"}}};
}

std::vector<CampaignRun> FakeRuns(int count) {
  std::vector<CampaignRun> runs;
  for (int i = 1; i <= count; ++i) {
    CampaignRun run;
    run.run = i;
    run.scenario.system = "fake";
    run.scenario.controller = "straight";
    run.scenario.seed = WorldSeed(7, static_cast<std::uint64_t>(i), 0);
    run.scenario.start.SetInFile("r_m", 2.0 + 0.5 * (i % 9));
    run.labels = {i % 2 == 0 ? "loose" : "compact", NumberText(run.scenario.start.on_plane().r)};
    runs.push_back(run);
  }
  return runs;
}

RunRecord FakeRecord(const CampaignRun& run) {
  RandomStream draw(StreamKey(run.scenario.seed, "fake"));
  RunRecord record;
  record.columns = FakeColumns();
  record.channels = {{"tension_n", "N", "of the rope"}, {"roll_deg", "deg", "to the right"}};
  record.belief_columns = {{"recoveries", "", "so far"}};
  RunResult& row = record.result;
  row.run = run.run;
  row.seed = run.scenario.seed.number;
  row.system = run.scenario.system;
  row.controller = run.scenario.controller;
  row.labels = run.labels;
  row.success = run.run % 3 != 0;
  row.success_word = "docked";
  row.outcome = row.success ? "docked" : "missed";
  row.sim_time_s = draw.Uniform(100.0, 300.0);
  row.images = 14;
  row.measures = {draw.Normal() / 3.0, 0.1 + 0.2, draw.Normal()};  // 0.3...: no short decimal form
  row.state_hash = draw.NextBits();
  record.timing = {1.5, 2.5, 0.5, 0.75};
  record.failure_note = row.success ? "" : "it passed the flag on the left";
  for (int i = 0; i < 200; ++i) {
    HistorySample sample;
    sample.time_s = 0.1 * i;
    sample.X_DR = {4.0 - 0.01 * i, 0.3 * std::sin(0.05 * i), -3.0};
    sample.channels = {40.0 + draw.Normal(), -1.5};
    sample.phase = i < 100 ? "approach" : "mate";
    sample.beliefs = {i < 100 ? 0.0 : 1.0};
    record.history.push_back(sample);
  }
  SightingSample sample;
  sample.report.accepted = true;
  sample.report.detected = {3, 4};
  sample.report.marks = {{7, 1, 10.5, 20.25}};
  sample.X_DR = {4.0, 0.0, -3.0};
  sample.X_DR_measured = {4.1, 0.1, -3.0};
  record.sightings.push_back(sample);
  record.plans.push_back({1.0, {{{4.0, 0.0, -3.0}, 1.0, 0.5}, {{3.0, 0.1, -2.5}, 1.0, -0.5}}});
  return record;
}

FinishedRuns FakeResults(int count) {
  FinishedRuns runs;
  for (const CampaignRun& run : FakeRuns(count)) {
    const RunRecord record = FakeRecord(run);
    runs.Add({record.result, record.timing, record.failure_note});
  }
  return runs;
}

void WriteText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace dockyard
