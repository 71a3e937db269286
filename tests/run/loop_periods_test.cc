// Control periods of a run: what is called in each, and what ends the run.
#include "run/scripted_run.h"

namespace dockyard {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

class LoopPeriods : public ScriptedRun {};

TEST_F(LoopPeriods, EachIsSensedAnsweredJudgedAndAdvancedInThisOrder) {
  scenario_.time_limit_s = 0.04;
  Run();
  EXPECT_THAT(diary_.calls, ElementsAre("sense 0", "step 0", "observe 0", "advance 0", "sense 20",
                                        "step 20", "observe 20", "advance 20", "conclude 40"));
}

// A period that began before the limit is simulated to its end.
TEST_F(LoopPeriods, AreAsManyAsTheTimeLimitHoldsRoundedUp) {
  for (const Tick period : {10, 20, 30}) {
    for (const Tick limit : {0, 1, 19, 20, 21, 600, 990}) {
      script_.period = period;
      scenario_.time_limit_s = static_cast<double>(limit) * kTickSeconds;
      const RunRecord record = Run();
      const Tick periods = (limit + period - 1) / period;
      ASSERT_EQ(diary_.Count("step"), periods) << period << " " << limit;
      EXPECT_DOUBLE_EQ(record.result.sim_time_s, static_cast<double>(periods * period) * 1e-3);
      EXPECT_EQ(record.result.outcome, "timeout");
    }
  }
}

TEST_F(LoopPeriods, EndAfterTheOneWithTheControllersVerdict) {
  for (const auto& [verdict, outcome] :
       {std::pair{Verdict::kDone, "done"}, {Verdict::kGivenUp, "given_up"}}) {
    script_.step = [&, verdict = verdict](const SensorFrame& sensed, Commands& commands, Belief&) {
      commands.motors[0] = Speed(0.5);
      if (sensed.tick == 60) commands.verdict = verdict;
    };
    const RunRecord record = Run();
    EXPECT_THAT(diary_.TicksOf("advance"), ElementsAre(0, 20, 40, 60));
    EXPECT_EQ(diary_.commands.back().verdict, verdict);
    EXPECT_EQ(diary_.concluding, diary_.commands.back());
    EXPECT_EQ(record.result.outcome, outcome);
    EXPECT_EQ(record.result.success, verdict == Verdict::kDone);
    EXPECT_NEAR(record.result.measures.at(0), 0.5 * 0.08, 1e-12);  // the last period counts
  }
}

TEST_F(LoopPeriods, EndWhereTheJudgeFindsThatTheRunCannotGoOn) {
  script_.fatal = [](Tick tick) { return tick >= 60; };
  Run();
  EXPECT_THAT(diary_.TicksOf("sense"), ElementsAre(0, 20, 40));
  EXPECT_THAT(diary_.TicksOf("conclude"), ElementsAre(60));
}

TEST_F(LoopPeriods, WithoutAnyTheJudgeGetsBrakesAlone) {
  script_.fatal = [](Tick) { return true; };
  const RunRecord record = Run();
  EXPECT_TRUE(diary_.commands.empty());
  Commands brakes;
  brakes.motors.resize(1);
  brakes.motors[0].mode = MotorMode::kBrake;
  EXPECT_EQ(diary_.concluding, brakes);
  EXPECT_THAT(SampleTicks(record), ElementsAre(0));
}

// The plant stays where it is in all of these runs: only the commands differ.
TEST_F(LoopPeriods, FingerprintHasTheCommandsThatMoveNothing) {
  script_.cameras = 2;
  const auto print = [&](const std::vector<int>& cameras, double stops,
                         const std::vector<std::uint8_t>& switches) {
    script_.step = [=](const SensorFrame& sensed, Commands& commands, Belief&) {
      if (sensed.tick != 40) return;
      commands.take_images = cameras;
      commands.exposure_stops = stops;
      commands.switches = switches;
    };
    return Run().result.state_hash;
  };
  const std::vector<std::uint64_t> prints{print({}, 0.0, {}),     print({0}, 0.0, {}),
                                          print({1}, 0.0, {}),    print({0, 1}, 0.0, {}),
                                          print({0, 1}, 1.0, {}), print({}, 0.0, {1})};
  for (std::size_t i = 0; i < prints.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(prints[i], prints[k]) << i << " " << k;
  }
  EXPECT_EQ(print({}, 1.0, {}), prints[0]);  // an exposure of no image
}

TEST_F(LoopPeriods, GoOnInTheHistoryWhileTheJudgeTriesAClaim) {
  script_.step = [](const SensorFrame& sensed, Commands& commands, Belief& belief) {
    belief.phase = "drive";
    if (sensed.tick == 100) commands.verdict = Verdict::kDone;
  };
  for (const auto& [periods, trial] : {std::pair{13, std::vector<Tick>{220, 320, 380}},
                                       {10, std::vector<Tick>{220, 320}},
                                       {1, std::vector<Tick>{140}},
                                       {0, std::vector<Tick>{}}}) {
    script_.trial_periods = periods;
    const RunRecord record = Run();
    std::vector<Tick> ticks{0, 100, 120};
    ticks.insert(ticks.end(), trial.begin(), trial.end());
    EXPECT_THAT(SampleTicks(record), ElementsAreArray(ticks)) << periods;
    for (std::size_t i = 0; i < record.history.size(); ++i) {
      EXPECT_EQ(record.history[i].phase, i < 3 ? "drive" : "trial") << i;
    }
    EXPECT_DOUBLE_EQ(record.result.sim_time_s, 0.12);  // the claim's, not the trial's
  }
}

}  // namespace
}  // namespace dockyard
