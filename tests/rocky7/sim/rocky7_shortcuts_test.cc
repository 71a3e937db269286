// What a controller that took a short cut would not notice: its sensors are altered on the way to
// it, or the scene is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <utility>

#include "controller/rocky7/dockyard.h"
#include "rocky7/sim/test_scenario.h"
#include "sim/base/random.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/rocky7/rocky7_system.h"
#include "sim/run/loop.h"

namespace dockyard::rocky7 {
namespace {

using Alter = std::function<void(SensorFrame&)>;
using Notes = std::set<std::string>;

// Ours, with what it senses altered and what it says written down.
class Altered final : public Controller {
 public:
  Altered(const Nominal& nominal, Alter alter, Notes& notes)
      : inner_(MakeDockyardController(nominal)), alter_(std::move(alter)), notes_(notes) {}

  Commands Step(const SensorFrame& sensed) override {
    SensorFrame frame = sensed;
    alter_(frame);
    const Commands commands = inner_->Step(frame);
    notes_.insert(inner_->belief().note);
    return commands;
  }
  const Belief& belief() const override { return inner_->belief(); }

 private:
  std::unique_ptr<Controller> inner_;
  Alter alter_;
  Notes& notes_;
};

struct Ended {
  std::string outcome;
  Notes notes;
};

Scenario NearStone(const std::string& keys) {
  Scenario scenario = OnGravel("{" + keys + "}", 1.0, 4.0);
  scenario.controller = "altered";
  scenario.start = {1.0, 0.0, Radians(3.0)};
  scenario.time_limit_s = 120.0;
  scenario.seed = 3;
  return scenario;
}

Ended RunWith(const std::string& keys, const Alter& alter) {
  CampaignRun run;
  run.scenario = NearStone(keys);
  Ended ended;
  const System system =
      Rocky7System({{"altered", [&](const Nominal& nominal) {
                       return std::make_unique<Altered>(nominal, alter, ended.notes);
                     }}});
  const RunRecord record = Simulate(system, run, {});
  ended.outcome = record.result.outcome;
  return ended;
}

const Alter kNothing = [](SensorFrame&) {};

TEST(Rocky7Shortcuts, WithItsPicturesSwappedItDoesNotReachTheStone) {
  const Ended swapped = RunWith("task: reach", [](SensorFrame& frame) {
    for (CameraImage& image : frame.images) image.camera = kFrontRight - image.camera;
  });
  EXPECT_NE(swapped.outcome, "on_target");
}

// Shaded facets alone are enough to match: it is not the stones' dark colour that is tracked.
TEST(Rocky7Shortcuts, FindsAStoneOfTheSoilsOwnColourWithoutStains) {
  const Ended plain = RunWith("task: reach, stone_albedo: 1, stone_stains: 0", kNothing);
  EXPECT_EQ(plain.outcome, "on_target");
}

// All the world of one colour, from the second image pair on: the images alone tell where the
// stone is.
TEST(Rocky7Shortcuts, InPicturesOfOneGreyItLosesTheStone) {
  int pictures = 0;
  const Ended blank = RunWith("task: reach", [&](SensorFrame& frame) {
    for (CameraImage& image : frame.images) {
      if (++pictures <= 2) continue;
      auto& pixels = std::get<GrayImage>(image.pixels).pixels;
      std::fill(pixels.begin(), pixels.end(), 100);
    }
  });
  EXPECT_GT(pictures, 4);
  EXPECT_THAT(blank.outcome, testing::AnyOf("lost_target", "unstable"));
}

// Two worlds alike but for the stone turn by the same commands; from 8 s on the pictures are of the
// one whose stone is a pebble that nobody can tell from the ground.
TEST(Rocky7Shortcuts, WhenTheStoneIsTakenAwayHalfWayItReportsTheLoss) {
  const auto renderer = std::make_shared<KeptRenderer>();
  const auto plant = [&](const std::string& diameter_m) {
    const Scenario scenario = NearStone("task: reach, diameter_m: " + diameter_m);
    return std::make_unique<Rocky7Plant>(scenario, BuildRun(scenario, LoadModels(scenario)),
                                         renderer);
  };
  const auto with = plant("0.04"), without = plant("0.01, height_m: 0.005");
  const auto controller = MakeDockyardController(with->built().nominal);
  Commands commands;
  std::vector<CameraImage> images;
  int found = 0;
  while (commands.verdict == Verdict::kUnderWay && with->tick() < 240000) {
    SensorFrame sensed = with->Sense();
    without->Sense();
    sensed.images = std::exchange(images, {});
    commands = controller->Step(sensed);
    if (!commands.take_images.empty()) {
      const bool gone = with->tick() >= 8000;
      images = (gone ? without : with)->TakeImages(commands.take_images, commands.exposure_stops);
      for (CameraImage& image : images) image.exposed = with->tick();
      found += !gone;
    }
    with->Advance(commands);
    without->Advance(commands);
  }
  EXPECT_GE(found, 2);
  EXPECT_EQ(commands.verdict, Verdict::kGivenUp) << controller->belief().note;
}

bool Inspected(const Ended& ended) {
  return ended.notes.contains("no stone stands there any more") ||
         ended.notes.contains("the stone still stands there");
}

// A grasp that is believed by the scoops alone, or by the arm's weight, would not notice sand.
TEST(Rocky7Shortcuts, InspectsThePlaceAfterAGrasp) {
  const Ended usual = RunWith("task: grasp", kNothing);
  EXPECT_EQ(usual.outcome, "grasped");
  EXPECT_TRUE(Inspected(usual));
}

TEST(Rocky7Shortcuts, InTenTimesTheCurrentsNoiseItLooksWhetherTheStoneIsGone) {
  RandomStream random(9);
  const Ended noisy = RunWith("task: grasp", [&](SensorFrame& frame) {
    for (MotorReading& motor : frame.motors) {
      motor.current_a = std::abs(motor.current_a + 0.1 * random.Normal());
    }
  });
  EXPECT_TRUE(Inspected(noisy)) << noisy.outcome;
}

TEST(Rocky7Shortcuts, WithCurrentsThatReadNothingItLooksToo) {
  const Ended stuck = RunWith("task: grasp", [](SensorFrame& frame) {
    for (MotorReading& motor : frame.motors) motor.current_a = 0.0;
  });
  EXPECT_TRUE(Inspected(stuck)) << stuck.outcome;
}

}  // namespace
}  // namespace dockyard::rocky7
