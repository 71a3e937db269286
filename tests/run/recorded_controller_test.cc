// A run whose commands come from a log.
#include "sim/run/recorded_controller.h"

#include "run/scripted_run.h"
#include "sim/bridge/pipe_controller.h"
#include "sim/log/logged_run.h"

namespace dockyard {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::IsEmpty;

class RecordedRun : public ScriptedRun {
 protected:
  RecordedRun() {
    script_.cameras = 2;
    // Something else in each period, by the readings.
    script_.step = [](const SensorFrame& sensed, Commands& commands, Belief& belief) {
      const auto place = static_cast<double>(sensed.motors[0].encoder_counts);
      commands.motors[0] = Speed(0.1 + 1e-3 * place);
      commands.take_images.assign(1, static_cast<int>(sensed.tick / 20 % 2));
      commands.exposure_stops = 0.01 * static_cast<double>(sensed.tick);
      commands.switches = {static_cast<std::uint8_t>(sensed.tick % 40 == 0)};
      if (sensed.tick == 240) commands.verdict = Verdict::kDone;
      belief.phase = sensed.tick < 120 ? "far" : "near";
      belief.located = true;
      belief.X_DR = {place, 0.0, 0.0};
      belief.values = {{"place", place}};
      if (sensed.tick % 80 != 40) return;
      ++belief.sighting_count;
      belief.last_sighting.emplace();
      belief.last_sighting->accepted = belief.sighting_count > 1;
      belief.last_sighting->reprojection_px = place;
    };
    scenario_.time_limit_s = 1.0;
  }
  /// The run again, by the commands of its log. The controller itself is not asked.
  RunRecord Again() {
    script_.step = [](const SensorFrame&, Commands&, Belief&) { FAIL() << "not by the log"; };
    RunOptions options;
    options.recorded_dir = Folder(folder_.path());
    return Run(options);
  }
  /// The message of a log that does not fit.
  std::string Refused() {
    try {
      Again();
    } catch (const DataError& error) {
      return error.what();
    }
    return "(not refused)";
  }
};

TEST_F(RecordedRun, HasEachCommandOfItsLogBitForBit) {
  const RunRecord first = Run(Logged());
  const std::vector<Commands> commands = diary_.commands;
  const std::vector<Exposure> exposures = diary_.exposures;
  ASSERT_EQ(commands.size(), 13u);
  const RunRecord again = Again();
  EXPECT_THAT(diary_.commands, ElementsAreArray(commands));
  EXPECT_THAT(diary_.exposures, ElementsAreArray(exposures));
  EXPECT_EQ(again.result.state_hash, first.result.state_hash);
  EXPECT_EQ(again.result.outcome, "done");
  EXPECT_EQ(again.result.measures, first.result.measures);
}

TEST_F(RecordedRun, HasTheBeliefsOfItsLogInItsHistory) {
  const RunRecord first = Run(Logged()), again = Again();
  EXPECT_EQ(again.value_names, first.value_names);
  ASSERT_THAT(SampleTicks(again), ElementsAre(0, 100, 200, 260));
  for (std::size_t i = 0; i < first.history.size(); ++i) {
    EXPECT_EQ(again.history[i].phase, first.history[i].phase) << i;
    EXPECT_EQ(again.history[i].located, first.history[i].located) << i;
    EXPECT_EQ(again.history[i].X_DR_believed.x, first.history[i].X_DR_believed.x) << i;
    EXPECT_EQ(again.history[i].values, first.history[i].values) << i;
    EXPECT_EQ(again.history[i].sighting_count, first.history[i].sighting_count) << i;
  }
}

TEST_F(RecordedRun, HasTheSightingsOfItsLogAtTheirTimes) {
  const RunRecord first = Run(Logged());
  const std::vector<Tick> judged = diary_.TicksOf("sighting");
  ASSERT_THAT(judged, ElementsAre(40, 120, 200));
  const RunRecord again = Again();
  ASSERT_EQ(again.sightings.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.sightings[i].time_s, first.sightings[i].time_s);
    EXPECT_EQ(again.sightings[i].report.accepted, i > 0);
    EXPECT_EQ(again.sightings[i].report.reprojection_px, first.sightings[i].report.reprojection_px);
  }
  EXPECT_EQ(diary_.TicksOf("sighting"), judged);
  // A program numbers the marks of its sightings as it likes: the judge gets none of them.
  scenario_.command = {"program"};
  EXPECT_EQ(Again().sightings.size(), 3u);
  EXPECT_THAT(diary_.TicksOf("sighting"), IsEmpty());
}

TEST_F(RecordedRun, ComparesNoImages) {
  Run(Logged());
  script_.pixels = [](int) { return std::vector<std::uint8_t>{1, 2, 3}; };
  EXPECT_EQ(Again().result.outcome, "done");
  EXPECT_EQ(diary_.commands.size(), 13u);
}

TEST_F(RecordedRun, RefusesALogOfOtherPeriods) {
  Run(Logged());
  script_.period = 40;
  EXPECT_THAT(Refused(), HasSubstr("at tick 20: its readings are not those of this world"));
}

TEST_F(RecordedRun, RefusesALogThatEndsBeforeTheRun) {
  scenario_.time_limit_s = 0.1;
  Run(Logged());
  EXPECT_EQ(Again().result.outcome, "timeout");
  scenario_.time_limit_s = 0.12;
  EXPECT_EQ(Refused(), "the log ends before the run does");
}

// As of a run whose process died: its controller throws what the loop does not take.
TEST_F(RecordedRun, RefusesALogThatIsCutShort) {
  const auto step = script_.step;
  script_.step = [step](const SensorFrame& sensed, Commands& commands, Belief& belief) {
    if (sensed.tick == 60) throw std::runtime_error("a fault of ours");
    step(sensed, commands, belief);
  };
  EXPECT_THROW(Run(Logged()), std::runtime_error);
  EXPECT_FALSE(ReadLoggedRun(folder_.path()).complete);
  EXPECT_THAT(Refused(), HasSubstr("the log is cut short"));
}

TEST_F(RecordedRun, RefusesAFolderWithoutALog) { EXPECT_THROW(Again(), IoError); }

TEST_F(RecordedRun, FailsAsItsProgramDid) {
  const auto step = script_.step;
  for (const char* outcome : {kControllerCrashed, kControllerTimeout, kControllerError}) {
    script_.step = [step, outcome](const SensorFrame& sensed, Commands& commands, Belief& belief) {
      if (sensed.tick == 100) throw ControllerFailure(outcome, "the wheel fell off");
      step(sensed, commands, belief);
    };
    const RunRecord first = Run(Logged()), again = Again();
    EXPECT_EQ(again.result.outcome, outcome);
    EXPECT_EQ(again.failure_note, "the wheel fell off");
    EXPECT_EQ(again.result.sim_time_s, first.result.sim_time_s);
    EXPECT_EQ(again.result.state_hash, first.result.state_hash);
  }
}

}  // namespace
}  // namespace dockyard
