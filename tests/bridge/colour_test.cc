// A colour image on its way from a plant to a controller: in our process, through the pipe, and
// through the log.
#include <gtest/gtest.h>

#include "sim/base/hash.h"
#include "sim/base/text.h"
#include "sim/log/logged_run.h"
#include "sim/log/run_log.h"
#include "sim/run/loop.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

constexpr int kColourCamera = 1;
constexpr Tick kPeriod = 20;

RgbImage ImageAt(Tick tick) {
  RgbImage image{.width = 3, .height = 2, .pixels = {}};
  for (int i = 0; i < 18; ++i) image.pixels.push_back(static_cast<std::uint8_t>(tick + 37 * i));
  return image;
}

/// Camera 0 is grey, camera 1 sees other colours at every tick.
class ColourPlant final : public Plant {
 public:
  Tick tick() const override { return tick_; }
  SensorFrame Sense() override { return {.tick = tick_, .motors = {{}}}; }
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras, double) override {
    std::vector<CameraImage> images;
    for (const int camera : cameras) {
      if (camera == kColourCamera) images.push_back({camera, ImageAt(tick_)});
    }
    return images;
  }
  void Advance(const Commands& commands) override {
    target_ = commands.motors[0].target;
    tick_ += kPeriod;
  }
  Pose2 X_DR() const override { return {}; }
  void AppendChannels(std::vector<double>&) const override {}
  Pose2 MeasuredPose(const SightingReport&) const override { return {}; }
  std::uint64_t StateHash(std::uint64_t seed) const override { return HashDouble(seed, target_); }

 private:
  Tick tick_ = 0;
  double target_ = 0.0;
};

class EndsWell final : public Judge {
 public:
  void Observe() override {}
  void ObserveSighting(const SightingReport&) override {
    ADD_FAILURE() << "a program's marks have numbers of its own, and no judge reads them";
  }
  bool fatal() const override { return false; }
  Conclusion Conclude(const Commands& last, const Belief&, const TrialWatch&) override {
    return {"seen", NumberText(last.motors[0].target), {}};
  }
};

/// A number in which every byte of the image counts.
class ColourController final : public Controller {
 public:
  Commands Step(const SensorFrame& sensed) override {
    double target = 0.0;
    if (const RgbImage* image = RgbImageOf(sensed, kColourCamera)) {
      for (std::size_t i = 0; i < image->pixels.size(); ++i) {
        target += static_cast<double>((i + 1) * image->pixels[i]);
      }
    }
    return {.motors = {{.mode = MotorMode::kVelocity, .target = target}},
            .take_images = {kColourCamera},
            .verdict = sensed.tick >= 200 ? Verdict::kDone : Verdict::kUnderWay};
  }
  const Belief& belief() const override { return belief_; }

 private:
  Belief belief_;
};

System ColourSystem() {
  System system;
  system.name = "colour";
  system.controllers = {{"own", [](const Json&) { return std::make_unique<ColourController>(); }}};
  system.columns.outcomes = {{"seen", true, "at its end"}};
  system.make_ready = [](const Scenario&) {
    ReadyRun ready;
    ready.plant = std::make_unique<ColourPlant>();
    ready.judge = std::make_unique<EndsWell>();
    ready.nominal = {{"colour_camera", kColourCamera}};
    ready.control_period = kPeriod;
    ready.motor_count = 1;
    ready.camera_count = 2;
    return ready;
  };
  return system;
}

class Colour : public testing::Test {
 protected:
  RunRecord Run(const std::vector<std::string>& command, const std::filesystem::path& log_dir) {
    CampaignRun run;
    run.run = 1;
    run.scenario.system = "colour";
    run.scenario.controller = command.empty() ? "own" : "command";
    run.scenario.command = command;
    run.scenario.command_folder = SourceFile("tests/bridge");
    return Simulate(system_, run, {.log_dir = log_dir, .labels = {}, .allow_commands = true});
  }
  const System system_ = ColourSystem();
  const TemporaryFolder folder_;
};

TEST_F(Colour, ReachesAControllerOfOurs) {
  const RunRecord record = Run({}, {});
  EXPECT_EQ(record.result.images, 10);  // all frames but the first
  double sum = 0.0;
  for (int i = 0; i < 18; ++i) sum += (i + 1) * static_cast<double>((200 + 37 * i) % 256);
  EXPECT_EQ(record.failure_note, NumberText(sum));
}

TEST_F(Colour, ReachesAProgramBitForBit) {
  const RunRecord inside = Run({}, {}), outside = Run({"python3", "colour_controller.py"}, {});
  EXPECT_EQ(outside.result.outcome, "seen") << outside.messages;
  EXPECT_EQ(outside.result.state_hash, inside.result.state_hash);
}

TEST_F(Colour, HasTheProgramsMarksAtTheTimeOfItsImage) {
  Run({"python3", "colour_controller.py"}, folder_.path());
  const LoggedRun run = ReadLoggedRun(folder_.path());
  ASSERT_EQ(run.sightings.size(), 10u);
  for (const SightingSample& sighting : run.sightings) {
    ASSERT_EQ(sighting.report.marks.size(), 1u);
    EXPECT_EQ(sighting.report.marks[0].id, 7);
    EXPECT_EQ(sighting.report.marks[0].camera, kColourCamera);
    EXPECT_EQ(sighting.report.marks[0].v_px, 0.5);
    EXPECT_NE(run.ImageAt(std::to_string(kColourCamera), sighting.time_s), nullptr);
  }
}

TEST_F(Colour, StandsInTheLogAndReplays) {
  Run({}, folder_.path());
  RunLogReader log(folder_.path());
  int images = 0;
  while (const auto entry = log.Next()) {
    const RgbImage* image = RgbImageOf(entry->sensed, kColourCamera);
    if (image == nullptr) continue;
    ++images;
    EXPECT_EQ(*image, ImageAt(entry->sensed.tick));
    EXPECT_EQ(GrayImageOf(entry->sensed, kColourCamera), nullptr);
  }
  EXPECT_EQ(images, 10);
  ColourController again;
  RunLogReader from_the_start(folder_.path());
  const ControllerReplay replay =
      ReplayController(from_the_start, again, {.motors = 1, .cameras = 2});
  EXPECT_TRUE(replay.same());
  EXPECT_EQ(replay.compared, 11u);
}

}  // namespace
}  // namespace dockyard
