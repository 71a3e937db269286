// Controllers that fail, that cannot be made, or that a scenario may not have.
#include "models/read/config_error.h"
#include "run/scripted_run.h"
#include "sim/bridge/pipe_controller.h"

namespace dockyard {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class LoopFailures : public ScriptedRun {
 protected:
  std::string Refused(const System& system) {
    try {
      Simulate(system, Planned(), {});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "(not refused)";
  }
};

TEST_F(LoopFailures, AreTheOutcomeOfARunThatIsJudgedAllTheSame) {
  script_.step = [](const SensorFrame& sensed, Commands& commands, Belief& belief) {
    commands.motors[0] = Speed(0.5);
    belief.phase = "drive";
    if (sensed.tick == 60) {
      throw ControllerFailure(kControllerError, "it said nonsense", "last words", {1.5, 0.5});
    }
  };
  const RunRecord record = Run();
  EXPECT_EQ(record.result.outcome, kControllerError);
  EXPECT_FALSE(record.result.success);
  EXPECT_EQ(record.failure_note, "it said nonsense");
  EXPECT_EQ(record.messages, "last words");
  EXPECT_EQ(record.timing.controller_wall_s, 1.5);
  EXPECT_EQ(record.timing.controller_cpu_s, 0.5);
  EXPECT_THAT(diary_.TicksOf("advance"), ElementsAre(0, 20, 40));
  EXPECT_THAT(diary_.TicksOf("conclude"), ElementsAre(60));
  ASSERT_EQ(record.result.measures.size(), 1u);
  EXPECT_NEAR(record.result.measures[0], 0.5 * 0.06, 1e-12);
  EXPECT_THAT(SampleTicks(record), ElementsAre(0, 60));
}

TEST_F(LoopFailures, OfTheMakingLeaveNoHistory) {
  System system = ScriptedSystem(script_, diary_);
  system.controllers[0].make = [](const Json&) -> std::unique_ptr<Controller> {
    throw ControllerFailure(kControllerCrashed, "it never began");
  };
  const RunRecord record = Simulate(system, Planned(), {});
  EXPECT_EQ(record.result.outcome, kControllerCrashed);
  EXPECT_EQ(record.result.sim_time_s, 0.0);
  EXPECT_THAT(record.history, IsEmpty());
  EXPECT_THAT(diary_.calls, ElementsAre("conclude 0"));
}

TEST_F(LoopFailures, OfTheWallTimeAreLostRunsWithoutMeasures) {
  RunOptions options;
  options.run_limit_s = 1e-9;
  const RunRecord record = Run(options);
  EXPECT_EQ(record.result.outcome, kStopped);
  EXPECT_EQ(record.failure_note, OutOfTime(1e-9));
  EXPECT_THAT(record.result.measures, IsEmpty());
  EXPECT_THAT(diary_.frames, IsEmpty());
  options.run_limit_s = 600.0;
  EXPECT_EQ(Run(options).result.outcome, "timeout");
}

TEST_F(LoopFailures, OfOtherKindsLeaveTheRun) {
  script_.step = [](const SensorFrame&, Commands&, Belief&) { throw ConfigError("no such mast"); };
  EXPECT_EQ(Refused(ScriptedSystem(script_, diary_)), "no such mast");
  EXPECT_EQ(diary_.Count("conclude"), 0);
}

TEST_F(LoopFailures, NameThePlaceOfAScriptThatNoSystemTakes) {
  System system = ScriptedSystem(script_, diary_);
  scenario_.script = ParseYaml("{turns: 3}", "s.yaml");
  EXPECT_EQ(Refused(system),
            "s.yaml:1:1: script: expected none, as the system scripted takes no script");
  std::string played;
  system.play = [&](const Json& nominal, const YamlNode& script) {
    played = script.Find("turns")->scalar;
    return system.controllers[0].make(nominal);
  };
  scenario_.controller = "nobody's";  // a script is in its place
  EXPECT_EQ(Refused(system), "(not refused)");
  EXPECT_EQ(played, "3");
}

TEST_F(LoopFailures, AreRowsOfTheirRunWithItsNumberAndSeed) {
  scenario_.seed = 41;
  script_.step = [](const SensorFrame&, Commands&, Belief&) {
    throw ControllerFailure(kControllerTimeout, "silence");
  };
  const RunResult failed = Run().result, start = StartOfRow(Planned());
  for (const RunResult& row : {failed, start}) {
    EXPECT_EQ(row.run, 7);
    EXPECT_EQ(row.seed, 41u);
    EXPECT_EQ(row.system, "scripted");
    EXPECT_EQ(row.controller, "scripted");
  }
  EXPECT_EQ(start.outcome, kCrashed);  // until it is known better
}

}  // namespace
}  // namespace dockyard
