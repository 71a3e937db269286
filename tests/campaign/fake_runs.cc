#include "campaign/fake_runs.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "models/random.h"
#include "sim/log/result_row.h"

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

Campaign FakeCampaign(int count) {
  const Light lights[] = {Light::kEven, Light::kSpeckled, Light::kHardShadow};
  Campaign campaign;
  campaign.name = "fake";
  for (int i = 1; i <= count; ++i) {
    CampaignRun run;
    run.run = i;
    run.day = 1 + i % 3;
    run.region = i % 4 == 0 ? "boundary" : "interior";
    run.soil = i % 2 == 0 ? "loose" : "compact";
    run.scenario.seed = RunSeed(7, static_cast<std::uint64_t>(i));
    run.scenario.light = lights[i % 3];
    run.scenario.start = {2.0 + 0.5 * (i % 9), Radians(10.0 * (i % 9) - 40.0),
                          Radians(5.0 * (i % 5))};
    campaign.runs.push_back(run);
  }
  campaign.resolved_yaml = "name: fake\nruns: " + std::to_string(count) + "\n";
  return campaign;
}

RunRecord FakeRecord(const CampaignRun& run) {
  RandomStream draw(StreamKey(run.scenario.seed, "fake"));
  RunRecord record;
  RunResult& row = record.result = StartOfRow(run);
  row.docked = run.run % 3 != 0;
  row.outcome = row.docked ? Outcome::kDocked : Outcome::kMissedCone;
  row.sim_time_s = draw.Uniform(100.0, 300.0);
  row.image_pairs = 7;
  row.tip_depth_m = draw.Normal() / 3.0;
  row.cone_force_peak_n = 0.1 + 0.2;  // a number without a short decimal form
  row.state_hash = draw.NextBits();
  record.timing = {1.5, 2.5};
  record.failure_note = row.docked ? "" : "the tip passed the cone on the left";
  for (int i = 0; i < 200; ++i) {
    HistorySample sample;
    sample.time_s = 0.1 * i;
    sample.X_DR = {4.0 - 0.01 * i, 0.3 * std::sin(0.05 * i), -3.0};
    sample.tension_n = 40.0 + draw.Normal();
    sample.phase = i < 100 ? "approach" : "mate";
    record.history.push_back(sample);
  }
  SightingSample look;
  look.report.accepted = true;
  look.X_DR = {4.0, 0.0, -3.0};
  look.X_DR_measured = {4.1, 0.1, -3.0};
  record.sightings.push_back(look);
  record.plans.push_back({1.0, {{{4.0, 0.0, -3.0}, 1.0, 0.5}, {{3.0, 0.1, -2.5}, 1.0, -0.5}}});
  return record;
}

RunRecord FakeRun(const CampaignRun& run, const std::filesystem::path&) {
  std::this_thread::sleep_for(std::chrono::milliseconds(run.run % 2 == 1 ? 30 : 1));
  return FakeRecord(run);
}

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("no file " + path.string());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void WriteText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace dockyard
