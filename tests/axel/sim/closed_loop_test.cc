// The whole loop: physics, pixels and the real controller, on short runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "axel/sim/scenarios.h"
#include "sim/log/run_log.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

/// A folder that is removed after the test.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / ("dockyard_" + name)) {
    std::filesystem::remove_all(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::vector<RunLogEntry> ReadAll(const std::filesystem::path& dir) {
  RunLogReader reader(dir);
  std::vector<RunLogEntry> entries;
  while (auto entry = reader.Next()) entries.push_back(std::move(*entry));
  EXPECT_TRUE(reader.complete());
  return entries;
}

const std::vector<std::string> kShort{"start.r_m=2.5", "start.alpha_deg=5", "time_limit_s=40"};

TEST(ClosedLoop, TheSameSeedGivesTheSameRunBitForBit) {
  const RunRecord first = SimulateTypical(kShort);
  const RunRecord second = SimulateTypical(kShort);
  EXPECT_EQ(first.result.state_hash, second.result.state_hash);
  EXPECT_EQ(first.result.sim_time_s, second.result.sim_time_s);
  ASSERT_EQ(first.history.size(), second.history.size());
  EXPECT_EQ(Pose2(first.history.back().X_DR), Pose2(second.history.back().X_DR));
}

// The rest of 2 s, turns of 11 deg to and fro at 0.1 rad/s and 2 s of driving away.
TEST(ClosedLoop, HistoryGoesOnWhileTheJudgeShakesTheRover) {
  const RunRecord record = SimulateTypical(
      {"controller=reel_only", "start.r_m=1.5", "start.alpha_deg=0", "time_limit_s=100"});
  ASSERT_TRUE(record.result.success) << record.failure_note;
  double before_s = 0.0, turned_rad = 0.0;
  std::vector<std::string> phases;
  std::optional<Pose2> claimed;
  for (const HistorySample& sample : record.history) {
    EXPECT_LT(sample.time_s - before_s, 0.11);
    before_s = sample.time_s;
    if (phases.empty() || phases.back() != sample.phase) phases.push_back(sample.phase);
    if (sample.phase == "rest") {
      EXPECT_GT(sample.time_s, record.result.sim_time_s);
      if (!claimed) claimed = sample.X_DR;
    }
    if (sample.phase == "shake" && claimed) {
      turned_rad = std::max(turned_rad, std::abs(WrapPi(sample.X_DR.heading - claimed->heading)));
    }
  }
  EXPECT_THAT(phases, testing::ElementsAre("reel", "docked", "rest", "shake"));
  EXPECT_NEAR(record.history.back().time_s - record.result.sim_time_s, 2.0 + 7.68 + 2.0, 0.1);
  EXPECT_GT(turned_rad, Radians(0.2));  // play lets it turn
}

TEST(ClosedLoop, AnotherSeedGivesAnotherRun) {
  auto overrides = kShort;
  overrides.push_back("time_limit_s=5");
  const RunRecord first = SimulateTypical(overrides);
  overrides.push_back("seed=99");
  const RunRecord second = SimulateTypical(overrides);
  EXPECT_NE(first.result.state_hash, second.result.state_hash);
}

TEST(ClosedLoop, AControllerFedItsOwnLogGivesTheSameCommands) {
  const Folder folder("closed_loop_log");
  SimulateTypical(kShort, {.log_dir = folder.path(), .labels = {}});
  RunLogReader reader(folder.path());
  const std::vector<System> systems = Systems();
  const auto controller =
      systems.front().RequireController(reader.header().controller).make(reader.header().nominal);
  int frames = 0, image_frames = 0;
  while (const auto entry = reader.Next()) {
    ASSERT_EQ(controller->Step(entry->sensed), entry->commands) << "tick " << entry->sensed.tick;
    ++frames;
    image_frames += !entry->sensed.images.empty();
  }
  EXPECT_GT(frames, 1000);
  EXPECT_GT(image_frames, 0);
}

// Rounding differs in a world that lies elsewhere, and a docking amplifies it; the first sightings
// and drives must agree closely, image by image and command by command.
TEST(ClosedLoop, TheWholeWorldMovedAndTurnedChangesNoCommand) {
  const Folder here("closed_loop_here"), there("closed_loop_there");
  auto overrides = kShort;
  overrides.push_back("time_limit_s=25");
  const std::vector<System> systems = Systems();
  CampaignRun run = RunOf(TypicalScenario(overrides));
  Simulate(systems.front(), run, {.log_dir = here.path(), .labels = {}});
  run.scenario.X_WG = {310.0, -125.0, 2.1};
  Simulate(systems.front(), run, {.log_dir = there.path(), .labels = {}});
  const auto a = ReadAll(here.path()), b = ReadAll(there.path());
  ASSERT_EQ(a.size(), b.size());
  int image_frames = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "tick " << a[i].sensed.tick);
    ASSERT_NEAR(a[i].sensed.imu.pitch_rad, b[i].sensed.imu.pitch_rad, 1e-5);
    ASSERT_NEAR(a[i].sensed.imu.yaw_rad, b[i].sensed.imu.yaw_rad, 1e-5);
    for (int m = 0; m < kMotorCount; ++m) {
      ASSERT_LE(
          std::abs(a[i].sensed.motors[m].encoder_counts - b[i].sensed.motors[m].encoder_counts), 1);
      ASSERT_EQ(a[i].commands.motors[m].mode, b[i].commands.motors[m].mode);
      ASSERT_NEAR(a[i].commands.motors[m].target, b[i].commands.motors[m].target, 2e-3);
    }
    ASSERT_EQ(a[i].commands.take_images, b[i].commands.take_images);
    if (a[i].sensed.images.empty()) continue;
    ++image_frames;
    const auto& left = GrayImageOf(a[i].sensed, kLeftCamera)->pixels;
    const auto& moved = GrayImageOf(b[i].sensed, kLeftCamera)->pixels;
    double difference = 0.0;
    for (std::size_t p = 0; p < left.size(); ++p) difference += std::abs(left[p] - moved[p]);
    ASSERT_LT(difference / static_cast<double>(left.size()), 0.05);  // grey levels, mean
  }
  EXPECT_GT(image_frames, 0);
}

// Lenses with a pupil that moves, in the world and in the controller's calibration.
TEST(ClosedLoop, AShortDockingWithTheNavcamsOfMars2020Docks) {
  const std::string navcam = SourceFile("models/cameras/navcam.yaml");
  const RunRecord record = SimulateTypical(
      {"start.r_m=2.5", "start.alpha_deg=5", "time_limit_s=400", "camera.file=" + navcam});
  EXPECT_TRUE(record.result.success) << record.failure_note;
  EXPECT_GT(record.result.images, 0);
}

TEST(ClosedLoop, AxelWithItsMassesOnTheAxleDocks) {
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    const RunRecord record = SimulateTypical(
        {"robot=" + SourceFile("models/axel/axel_coaxial.yaml"), "start.r_m=2.5",
         "start.alpha_deg=5", "soil=" + SourceFile("models/soils/") + soil + ".yaml"});
    EXPECT_TRUE(record.result.success) << soil << ": " << record.failure_note;
  }
}

TEST(ClosedLoop, AShortDockingDocks) {
  const RunRecord record =
      SimulateTypical({"start.r_m=2.5", "start.alpha_deg=5", "time_limit_s=400"});
  EXPECT_TRUE(record.result.success) << record.failure_note;
  EXPECT_GT(record.result.images, 0);
}

}  // namespace
}  // namespace dockyard::axel
