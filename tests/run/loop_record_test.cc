// What a run keeps, and of which time.
#include "run/scripted_run.h"

namespace dockyard {
namespace {

using testing::ElementsAre;
using testing::IsNan;

class LoopRecord : public ScriptedRun {};

TEST_F(LoopRecord, HasASampleEveryTenthOfASecondAndOneAtTheEnd) {
  script_.step = [](const SensorFrame&, Commands& commands, Belief&) {
    commands.motors[0] = Speed(0.5);
  };
  scenario_.time_limit_s = 0.25;
  EXPECT_THAT(SampleTicks(Run()), ElementsAre(0, 100, 200, 260));
  scenario_.time_limit_s = 0.3;
  const RunRecord record = Run();
  EXPECT_THAT(SampleTicks(record), ElementsAre(0, 100, 200, 300));  // the end is one of them
  for (const HistorySample& each : record.history) {
    EXPECT_NEAR(each.X_DR.x, 0.5 * each.time_s, 1e-12);
    EXPECT_THAT(each.channels, ElementsAre(2.0 * each.X_DR.x));
  }
}

// The belief of a sample is the answer to the readings of its time; at the end it is the last.
TEST_F(LoopRecord, HasTheBeliefAfterTheAnswerOfItsTime) {
  script_.step = [](const SensorFrame& sensed, Commands&, Belief& belief) {
    belief.phase = "at " + std::to_string(sensed.tick);
    belief.located = sensed.tick > 0;
    belief.X_DR = {static_cast<double>(sensed.tick), 0.0, 0.0};
  };
  const RunRecord record = Run();
  ASSERT_THAT(SampleTicks(record), ElementsAre(0, 100, 200));
  const std::vector<Tick> answered{0, 100, 180};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(record.history[i].phase, "at " + std::to_string(answered[i]));
    EXPECT_EQ(record.history[i].located, i > 0);
    EXPECT_EQ(record.history[i].X_DR_believed.x, static_cast<double>(answered[i]));
  }
}

TEST_F(LoopRecord, HasAColumnForEachValueFromItsFirstTimeOn) {
  script_.step = [](const SensorFrame& sensed, Commands&, Belief& belief) {
    const auto now = static_cast<double>(sensed.tick);
    belief.values = {{"first", now}};
    if (sensed.tick >= 100) belief.values = {{"second", now}, {"stated_m", 5.0}};
  };
  const RunRecord record = Run();
  EXPECT_THAT(record.value_names, ElementsAre("first", "second"));
  ASSERT_EQ(record.history.size(), 3u);
  EXPECT_THAT(record.history[0].values, ElementsAre(0.0));
  EXPECT_THAT(record.history[1].values, ElementsAre(IsNan(), 100.0));
  EXPECT_THAT(record.history[0].beliefs, ElementsAre(IsNan()));
  EXPECT_THAT(record.history[1].beliefs, ElementsAre(5.0));  // the system's own column
}

TEST_F(LoopRecord, HasEachSightingWithTheTruthOfItsTime) {
  script_.step = [](const SensorFrame& sensed, Commands& commands, Belief& belief) {
    commands.motors[0] = Speed(1.0);
    if (sensed.tick == 20) belief.sighting_count = 1;  // a count without a report
    if (sensed.tick != 40 && sensed.tick != 120) return;
    ++belief.sighting_count;
    SightingReport report;
    report.accepted = sensed.tick == 40;
    report.X_RB.p.x() = 3.0;
    belief.last_sighting = report;
  };
  const RunRecord record = Run();
  ASSERT_EQ(record.sightings.size(), 2u);
  EXPECT_NEAR(record.sightings[0].time_s, 0.04, 1e-12);
  EXPECT_NEAR(record.sightings[1].time_s, 0.12, 1e-12);
  EXPECT_NEAR(record.sightings[1].X_DR.x, 0.12, 1e-12);
  EXPECT_EQ(record.sightings[0].X_DR_measured.x, 3.0);  // by the plant
  EXPECT_EQ(record.sightings[1].X_DR_measured.x, 0.0);  // none of a refused one
  EXPECT_THAT(diary_.TicksOf("sighting"), ElementsAre(40, 120));
}

TEST_F(LoopRecord, HasAPlanForEachTimeThatItsCountRises) {
  script_.step = [](const SensorFrame& sensed, Commands&, Belief& belief) {
    belief.plan = {{{}, static_cast<double>(sensed.tick), 0.5}};
    if (sensed.tick == 60 || sensed.tick == 80) ++belief.plan_count;
  };
  const RunRecord record = Run();
  ASSERT_EQ(record.plans.size(), 2u);
  for (const PlanSample& plan : record.plans) {
    ASSERT_EQ(plan.arcs.size(), 1u);
    EXPECT_NEAR(plan.arcs[0].length_m, 1e3 * plan.time_s, 1e-9);
  }
  EXPECT_NEAR(record.plans[0].time_s, 0.06, 1e-12);
}

TEST_F(LoopRecord, HasTheMarginOfEachLimitBehindTheMeasures) {
  script_.limits = {{"depth_m", "m", "a depth", LimitSense::kAtLeast, 0.3, 0.1},
                    {"force_n", "N", "a force", LimitSense::kAtMost, 30.0, 20.0}};
  const RunRecord record = Run();
  ASSERT_EQ(record.columns.measures.size(), 3u);
  EXPECT_EQ(record.columns.measures[2].name, "margin.force_n");
  EXPECT_THAT(record.result.measures, ElementsAre(0.0, 0.3 - 0.1, 20.0 - 30.0));
  EXPECT_EQ(record.limits.size(), 2u);
}

TEST_F(LoopRecord, TakesNoLimitsButThoseThatTheSystemStates) {
  script_.limits = {{"depth_m", "m", "a depth", LimitSense::kAtLeast, 0.3, 0.1}};
  const System system = ScriptedSystem(script_, diary_);
  const auto run = [&] { Simulate(system, Planned(), {}); };
  script_.limits[0].name = "width_m";
  EXPECT_DEATH(run(), "check failed");
  script_.limits.clear();
  EXPECT_DEATH(run(), "check failed");
}

TEST_F(LoopRecord, NamesTheSuccessThatTheTaskAsksFor) {
  EXPECT_EQ(Run().result.success_word, "done");  // the system's first
  script_.success_word = "given_up";
  EXPECT_EQ(Run().result.success_word, "given_up");
  System hopeless = ScriptedSystem(script_, diary_);
  script_.success_word.clear();
  for (OutcomeName& outcome : hopeless.columns.outcomes) outcome.success = false;
  EXPECT_EQ(Simulate(hopeless, Planned(), {}).result.success_word, "");
}

}  // namespace
}  // namespace dockyard
