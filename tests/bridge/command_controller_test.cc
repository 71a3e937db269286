// A controller in another process: the same run as in our own, and what its faults come to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.h"
#include "sim/base/json.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kScenario = "tests/toy/scenario.yaml --set start.r_m=1 ";

std::string Command(const std::string& words) {
  return "--set 'controller={command: [" + words +
         "], folder: " DOCKYARD_SOURCE_DIR "/tests/bridge}' ";
}

Json RunWith(const std::string& words, const std::string& more = "") {
  const Ended ended =
      Dockyard("run " + kScenario + Command(words) + "--allow-commands --json " + more);
  EXPECT_THAT(ended.code, testing::AnyOf(0, 4)) << ended.err;
  Json json = Json::parse(ended.out, nullptr, false);
  json["said"] = ended.err;
  return json;
}

TEST(CommandController, GivesTheSameRunAsTheSameControllerInOurProcess) {
  const Ended own = Dockyard("run " + kScenario + "--json");
  const Json inside = Json::parse(own.out), outside = RunWith("python3, counting.py");
  EXPECT_EQ(outside["state_hash"], inside["state_hash"]);
  EXPECT_EQ(outside["outcome"], inside["outcome"]);
  EXPECT_EQ(outside["miss_m"], inside["miss_m"]);
  EXPECT_EQ(outside["controller"], "command");
}

TEST(CommandController, ReplaysFromItsLog) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  RunWith("python3, counting.py", "--out " + out);
  const Ended replay = Dockyard("replay " + out + " --allow-commands");
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("controller alone: same commands at all"));
}

TEST(CommandController, IsNeverStartedUnasked) {
  const TemporaryFolder folder;
  const std::string mark = (folder.path() / "started").string();
  const std::string command = Command("touch, " + mark);
  EXPECT_EQ(Dockyard("run " + kScenario + command).code, 3);
  EXPECT_FALSE(fs::exists(mark));
  const Ended refused = Dockyard("run " + kScenario + command);
  EXPECT_THAT(refused.err, HasSubstr("--allow-commands"));
}

TEST(CommandController, ThatDiesIsAnOutcomeWithItsLastWords) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  const Json run = RunWith("python3, counting.py, crash", "--out " + out);
  EXPECT_EQ(run["outcome"], "controller_crashed");
  EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("RuntimeError: the wheel fell off"));
  EXPECT_THAT(Slurp(folder.path() / "run" / "messages.txt"), HasSubstr("the wheel fell off"));
  EXPECT_GT(run["sim_time_s"].get<double>(), 0.5);
}

TEST(CommandController, ThatCannotBeStartedSaysWhy) {
  const Json run = RunWith("no_such_program_here");
  EXPECT_EQ(run["outcome"], "controller_crashed");
  EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("cannot start no_such_program_here"));
}

TEST(CommandController, ThatHangsIsEndedAtTheAnswersLimit) {
  const Json run = RunWith("python3, counting.py, hang", "--answer-limit 0.5");
  EXPECT_EQ(run["outcome"], "controller_timeout");
}

TEST(CommandController, ThatAnswersNonsenseIsAnError) {
  EXPECT_EQ(RunWith("echo, hello world")["outcome"], "controller_error");
  EXPECT_EQ(RunWith("python3, counting.py, motors")["outcome"], "controller_error");
  EXPECT_EQ(RunWith("python3, counting.py, not_a_number")["outcome"], "controller_error");
}

TEST(CommandController, CostsOneRunOfACampaign) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const Ended end =
      Dockyard("campaign tests/toy/campaign.yaml --quiet --allow-commands --out " + out +
               " --set 'scenario={controller: {command: [python3, counting.py, crash], "
               "folder: " DOCKYARD_SOURCE_DIR "/tests/bridge}}'");
  EXPECT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("controller_crashed"));
  EXPECT_THAT(Slurp(folder.path() / "runs" / "001" / "messages.txt"),
              HasSubstr("the wheel fell off"));
}

}  // namespace
}  // namespace dockyard
