// The loop of one run by the toy system: seeds, logs, recorded commands, replays.
#include "sim/run/loop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/read/config_error.h"
#include "sim/run/recorded_controller.h"
#include "sim/run/replay_log.h"
#include "sim/run/start_images.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"
#include "toy/toy_system.h"

namespace dockyard {
namespace {

using testing::HasSubstr;

class Loop : public testing::Test {
 protected:
  CampaignRun Make(const std::vector<std::string>& changes) const {
    return {
        0, {}, LoadScenario(SourceFile("tests/toy/scenario.yaml"), changes, KnownSystems({toy_}))};
  }
  RunRecord Run(const std::vector<std::string>& changes, const RunOptions& options = {}) const {
    return Simulate(toy_, Make(changes), options);
  }
  RunOptions Logged() const { return {.log_dir = folder_.path(), .labels = {}}; }
  std::string Error(const std::function<void()>& call) const {
    try {
      call();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "(no error)";
  }

  ScratchFolder folder_;
  System toy_ = toy::ToySystem();
};

TEST_F(Loop, ARunIsAFunctionOfItsSeed) {
  const RunRecord first = Run({"seed=7"}), again = Run({"seed=7"}), other = Run({"seed=8"});
  EXPECT_EQ(first.result.state_hash, again.result.state_hash);
  EXPECT_EQ(first.history.size(), again.history.size());
  EXPECT_NE(first.result.state_hash, other.result.state_hash);
}

TEST_F(Loop, ALogChangesNothing) {
  EXPECT_EQ(Run({"seed=7"}).result.state_hash, Run({"seed=7"}, Logged()).result.state_hash);
}

TEST_F(Loop, TakesAsLongAsTheDistanceAtItsSpeed) {
  for (const double speed_m_s : {0.25, 0.5, 1.0}) {
    const RunRecord record = Run({"toy.speed_m_s=" + std::to_string(speed_m_s)});
    EXPECT_NEAR(record.result.sim_time_s, 2.0 / speed_m_s, 0.04) << speed_m_s;
  }
}

TEST_F(Loop, EndsAtItsTimeLimitWithoutAClaim) {
  const RunRecord record = Run({"time_limit_s=1"});
  EXPECT_EQ(record.result.outcome, "timeout");
  EXPECT_NEAR(record.result.sim_time_s, 1.0, 0.02);
}

TEST_F(Loop, RecordedCommandsMakeTheSameRun) {
  const RunRecord first = Run({"seed=7"}, Logged());
  RunOptions options;
  options.recorded_dir = Folder(folder_.path());
  const RunRecord again = Run({"seed=7"}, options);
  EXPECT_EQ(again.result.state_hash, first.result.state_hash);
  EXPECT_EQ(again.result.outcome, first.result.outcome);
  ASSERT_EQ(again.history.size(), first.history.size());
  for (std::size_t i = 1; i < first.history.size(); ++i) {
    EXPECT_EQ(again.history[i].phase, first.history[i].phase) << i;
  }
}

TEST_F(Loop, RecordedCommandsAreForTheirOwnWorldAlone) {
  Run({"seed=7", "toy.speed_m_s=0.5"}, Logged());
  RecordedController recorded(Folder(folder_.path()));
  SensorFrame frame = toy_.make_ready(Make({"seed=7"}).scenario).plant->Sense();
  EXPECT_EQ(recorded.Step(frame).motors.size(), 1u);
  frame.tick += 20;
  frame.motors[0].encoder_counts = -5;
  EXPECT_THAT(Error([&] { recorded.Step(frame); }),
              HasSubstr("at tick 20: its readings are not those of this world"));
}

TEST_F(Loop, ReplayComparesEachCommandWithTheLog) {
  const CampaignRun run = Make({"seed=7"});
  Simulate(toy_, run, Logged());
  const auto replay = [&](const System& system, const CampaignRun& of) {
    RunLogReader log{Folder(folder_.path())};
    return ReplayLog(log, system, of, system.make_ready(of.scenario), {});
  };
  const std::optional<ControllerReplay> same = replay(toy_, run);
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->same());
  EXPECT_NEAR(static_cast<double>(same->compared), 4.0 / 0.02, 10.0);
  // Other nominal parameters than the log's: nothing to compare.
  EXPECT_FALSE(replay(toy_, Make({"seed=7", "toy.speed_m_s=0.4"})));
  System other = toy_;
  other.name = "boat";
  EXPECT_THAT(Error([&] { replay(other, run); }), HasSubstr("expected one of the system boat"));
}

TEST_F(Loop, ReplayFindsTheFirstOtherCommand) {
  const CampaignRun run = Make({"seed=7"});
  Simulate(toy_, run, Logged());
  System other = toy_;
  const auto make = toy_.controllers[0].make;
  // Made as if it had to go half the distance, it stops too soon.
  other.controllers[0].make = [make](const Json& nominal) {
    Json half = nominal;
    half["distance_m"] = 0.5 * nominal.at("distance_m").get<double>();
    return make(half);
  };
  RunLogReader log{Folder(folder_.path())};
  const auto replay = ReplayLog(log, other, run, other.make_ready(run.scenario), {});
  ASSERT_TRUE(replay && replay->differs_at);
  EXPECT_NEAR(static_cast<double>(*replay->differs_at), 2000.0, 20.0);  // 1 m at 0.5 m/s
}

TEST_F(Loop, ARobotWithoutCamerasHasNoStartImages) {
  EXPECT_EQ(StartImages(toy_, Make({}).scenario), "");
}

TEST_F(Loop, StartImagesSayWhyThereAreNone) {
  System broken = toy_;
  broken.make_ready = [](const Scenario&) -> ReadyRun { throw ConfigError("no robot"); };
  EXPECT_EQ(StartImages(broken, Make({}).scenario), "none: no robot");
}

TEST_F(Loop, NamesAllControllersWhereOneIsUnknown) {
  EXPECT_THAT(Error([&] { Run({"controller=guessing"}); }), HasSubstr("counting"));
}

TEST_F(Loop, AProgramIsStartedWhereItMayBeAlone) {
  const CampaignRun run = Make({"controller={command: [\"true\"]}"});
  EXPECT_THAT(Error([&] { RequireAllowed(run.scenario, {}); }), HasSubstr("--allow-commands"));
  EXPECT_TRUE(StartsProgram(StartOfRow(run)));
  EXPECT_FALSE(StartsProgram(StartOfRow(Make({}))));
}

TEST(SeedOfProgram, DiffersFromRunToRunAndFollowsFromItsKey) {
  EXPECT_EQ(SeedOfProgram(3, 5), SeedOfProgram(3, 5));
  EXPECT_NE(SeedOfProgram(3, 5), SeedOfProgram(3, 6));
  EXPECT_NE(SeedOfProgram(3, 5), SeedOfProgram(4, 5));
}

}  // namespace
}  // namespace dockyard
