// Faulty cameras in the whole loop: each run ends, by an outcome of its own, and tells its losses.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axel/sim/scenarios.h"

namespace dockyard::axel {
namespace {

using Overrides = std::vector<std::string>;

constexpr double kLimit_s = 150.0;

/// The beginning of a docking from near.
RunRecord ShortDocking(Overrides faults) {
  faults.insert(faults.end(), {"start.r_m=2.5", "time_limit_s=150", "log_images=false"});
  return SimulateTypical(faults);
}

StereoImages StartPair(const Overrides& faults) {
  Overrides overrides = faults;
  overrides.push_back("start.r_m=2.5");
  const Scenario scenario = TypicalScenario(overrides);
  StereoImages pair;
  const ReadyRun ready = Systems().front().make_ready(scenario);
  for (CameraImage& image : ready.plant->TakeImages({kLeftCamera, kRightCamera}, 0.0)) {
    (image.camera == kLeftCamera ? pair.left : pair.right) = std::get<GrayImage>(image.pixels);
  }
  return pair;
}

double Mean(const GrayImage& image) {
  double sum = 0.0;
  for (const std::uint8_t pixel : image.pixels) sum += pixel;
  return sum / static_cast<double>(image.pixels.size());
}

TEST(CameraFaults, SwitchedOffNoNumberOfThemChangesABit) {
  const StereoImages plain = StartPair({});
  const StereoImages off =
      StartPair({"camera.window_m=0.05", "camera.pupil_m=0.001", "camera.left.cover=0",
                 "camera.left.cover_side_deg=77", "camera.right.dust=0",
                 "camera.right.dust_clump_m=0.001", "camera.right.dust_scatter=0.9"});
  EXPECT_EQ(plain.left.pixels, off.left.pixels);
  EXPECT_EQ(plain.right.pixels, off.right.pixels);
}

TEST(CameraFaults, SameSeedSameDustAndItDims) {
  const Overrides dust{"camera.left.dust=0.2"};
  EXPECT_EQ(StartPair(dust).left.pixels, StartPair(dust).left.pixels);
  const StereoImages plain = StartPair({}), dusty = StartPair(dust);
  EXPECT_NE(plain.left.pixels, dusty.left.pixels);
  EXPECT_LT(Mean(dusty.left), 0.95 * Mean(plain.left));
}

TEST(CameraFaults, CoverDarkensItsHalfOfItsOwnEyeAlone) {
  const StereoImages pair = StartPair({"camera.left.cover=0.5", "camera.left.cover_side_deg=180"});
  const int w = pair.left.width, y = pair.left.height / 4;  // in the sky
  EXPECT_LE(pair.left.at(w / 2 - 20, y), 2);
  EXPECT_GE(pair.left.at(w / 2 + 20, y), 40);
  EXPECT_GE(pair.right.at(w / 2 - 20, y), 40);
}

TEST(CameraFaults, DeadEyesGiveDarkOrNoPictures) {
  const StereoImages pair = StartPair({"camera.left.picture=dark", "camera.right.picture=none"});
  EXPECT_FALSE(pair.left.pixels.empty());
  EXPECT_LT(Mean(pair.left), 0.5);  // read noise of 15 electrons in 20000
  EXPECT_TRUE(pair.right.pixels.empty());
}

/// By an outcome that the system lists, in its time.
void ExpectOrdinaryEnd(const RunRecord& record) {
  const System system = Systems().front();
  bool known = false;
  for (const OutcomeName& outcome : system.columns.outcomes) {
    known = known || outcome.name == record.result.outcome;
  }
  EXPECT_TRUE(known) << record.result.outcome;
  EXPECT_LE(record.result.sim_time_s, kLimit_s + 5.0);
}

int Accepted(const RunRecord& record) {
  int count = 0;
  for (const SightingSample& sighting : record.sightings) count += sighting.report.accepted;
  return count;
}

TEST(CameraFaults, OneInFivePairsLostAreAskedForAgain) {
  const RunRecord record = ShortDocking({"camera.lost=0.2"});
  ExpectOrdinaryEnd(record);
  EXPECT_GE(MeasureOf(record, "pairs_lost"), 1.0);
  EXPECT_GE(Accepted(record), 3);
  const RunRecord again = ShortDocking({"camera.lost=0.2"});
  EXPECT_EQ(record.result.state_hash, again.result.state_hash);
  EXPECT_EQ(record.result.measures.back(), again.result.measures.back());
}

// Asked for six times, then the rover goes by its tether, and claims nothing that is not so.
TEST(CameraFaults, WithoutAnyPairOnlyTheTetherIsLeft) {
  const RunRecord record = ShortDocking({"camera.lost=1"});
  ExpectOrdinaryEnd(record);
  EXPECT_NE(record.result.outcome, "false_docked");
  EXPECT_EQ(record.result.images, 0);
  EXPECT_GE(MeasureOf(record, "pairs_lost"), 6.0);
}

// A stop's first pair is seen that much later; all else that happens before it is the same.
TEST(CameraFaults, LatePairsAreWaitedFor) {
  const RunRecord now = ShortDocking({});
  for (const double delay_s : {0.5, 0.9}) {
    const RunRecord late = ShortDocking({"camera.delay_s=" + std::to_string(delay_s)});
    ExpectOrdinaryEnd(late);
    EXPECT_EQ(MeasureOf(late, "pairs_lost"), 0.0);
    ASSERT_GE(Accepted(late), 3);
    EXPECT_NEAR(late.sightings[0].time_s - now.sightings[0].time_s, delay_s, 1e-9);
    EXPECT_EQ(late.sightings[0].report.X_RB.p, now.sightings[0].report.X_RB.p);
  }
  // Asked anew after 1 s and after 2 s more; the third pair is given 4 s.
  const RunRecord slow = ShortDocking({"camera.delay_s=2.5"});
  ExpectOrdinaryEnd(slow);
  EXPECT_GE(Accepted(slow), 3);
  EXPECT_NEAR(slow.sightings[0].time_s - now.sightings[0].time_s, 3.0 + 2.5, 0.02 + 1e-9);
}

TEST(CameraFaults, OneDeadEyeLeavesTheOther) {
  for (const bool left : {true, false}) {
    const RunRecord record =
        ShortDocking({left ? "camera.left.picture=dark" : "camera.right.picture=none"});
    ExpectOrdinaryEnd(record);
    EXPECT_GE(Accepted(record), 3);
    for (const SightingSample& sighting : record.sightings) {
      if (!sighting.report.accepted) continue;
      EXPECT_EQ(sighting.report.method, left ? "right" : "left");
    }
  }
}

// Nothing to see by: the tether leads a rover that stands on the cone's axis into it.
TEST(CameraFaults, TwoDeadEyesLeaveTheTether) {
  const RunRecord record =
      SimulateTypical({"camera.left.picture=none", "camera.right.picture=none", "start.r_m=2.5",
                       "start.alpha_deg=0", "time_limit_s=300", "log_images=false"});
  EXPECT_EQ(Accepted(record), 0);
  EXPECT_TRUE(record.result.docked) << record.failure_note;
  EXPECT_LT(record.result.sim_time_s, 300.0);
}

TEST(CameraFaults, CoveredAndDustyEyesEndTheRunByAnOrdinaryOutcome) {
  for (const Overrides& faults : {Overrides{"camera.left.cover=0.5", "camera.right.cover=0.5"},
                                  Overrides{"camera.left.dust=0.2", "camera.right.dust=0.2"}}) {
    const RunRecord record = ShortDocking(faults);
    ExpectOrdinaryEnd(record);
    EXPECT_GE(Accepted(record), 1);
  }
}

}  // namespace
}  // namespace dockyard::axel
