// Which runs of a campaign are simulated with a log, and which twice.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <set>

#include "models/read/yaml_tree.h"
#include "sim/campaign/campaign.h"
#include "sim/scenario/key_path.h"
#include "support/fake_campaign.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
namespace fs = std::filesystem;

class RunLogsTest : public testing::Test {
 protected:
  /// Every third run fails.
  ShardEnd Run(const Keep& keep, int count, bool drifts = false, bool dies = false,
               bool of_program = false) {
    Campaign campaign = FakeCampaign(count);
    campaign.keep = keep;
    if (of_program) {
      YamlNode controller = ParseYaml("{command: [x]}", "test");
      controller.keys.push_back({"folder", {}});
      controller.items.push_back(ScalarNode(folder_.path().string(), true));
      PutPath(campaign.base, "controller", {}, controller);
    }
    CampaignOptions options;
    options.out_dir = out_;
    options.systems = FakeSystems();
    options.columns = FakeColumns();
    options.identity.campaign_yaml = CampaignYaml(campaign);
    const auto simulate = [&](const CampaignRun& run, const RunLogging& logging) {
      const bool logs = !logging.dir.empty();
      std::ofstream(folder_.path() / "calls", std::ios::app)
          << (logs ? "log " : "row ") << run.run << "\n";
      if (dies && logs) ::_exit(9);
      RunRecord record = FakeRecord(run);
      if (drifts && logs) ++record.result.images;
      return record;
    };
    return RunShard(campaign, simulate, options);
  }
  /// In order, each as "row 3" or "log 3".
  std::vector<std::string> Calls() const {
    std::ifstream in(folder_.path() / "calls");
    std::vector<std::string> calls;
    for (std::string line; std::getline(in, line);) calls.push_back(line);
    return calls;
  }
  std::set<std::string> Logged() const {
    std::set<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(out_ / "runs", none)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  const TemporaryFolder folder_;
  const fs::path out_ = folder_.path() / "out";
};

TEST_F(RunLogsTest, OnlyAFailureThatStaysIsSimulatedAgain) {
  EXPECT_TRUE(Run({1, 0, true}, 6).not_repeated.empty());
  EXPECT_THAT(Calls(), ElementsAre("row 1", "row 2", "row 3", "log 3", "row 4", "row 5", "row 6"));
  EXPECT_EQ(Logged(), std::set<std::string>{"003"});
}

TEST_F(RunLogsTest, ASuccessThatStaysLogsAtOnce) {
  Run({0, 1, true}, 3);
  EXPECT_THAT(Calls(), ElementsAre("log 1", "log 2", "log 3"));
  EXPECT_EQ(Logged(), (std::set<std::string>{"001", "002"}));
}

TEST_F(RunLogsTest, SightingsOfAllRunsNeedNoLog) {
  Run({0, 0, true, true}, 2);
  EXPECT_THAT(Calls(), ElementsAre("row 1", "row 2"));
  EXPECT_THAT(Slurp(out_ / "sightings/002.json"), ::testing::HasSubstr("\"accepted\": true"));
}

TEST_F(RunLogsTest, AFailureWhoseLogWasNotWrittenInTimeGetsItWhenTheCampaignGoesOn) {
  Run({1, 0, true}, 6);
  fs::remove_all(out_ / "runs/003");
  fs::remove(folder_.path() / "calls");
  Run({1, 0, true}, 6);
  EXPECT_THAT(Calls(), ElementsAre("log 3"));
  EXPECT_EQ(Logged(), std::set<std::string>{"003"});
}

TEST_F(RunLogsTest, ALostRunOfAProgramKeepsWhatItLogged) {
  Run({-1, 0, true}, 3, /*drifts=*/false, /*dies=*/true, /*of_program=*/true);
  // Each run of a program logs its commands; a lost one is tried twice, and not for its log.
  EXPECT_THAT(Calls(), ElementsAre("log 1", "log 1", "log 2", "log 2", "log 3", "log 3"));
  EXPECT_EQ(Logged(), (std::set<std::string>{"001", "002", "003"}));
}

TEST_F(RunLogsTest, ARunThatComesToAnotherRowIsReported) {
  const ShardEnd end = Run({-1, 0, true}, 4, /*drifts=*/true);
  ASSERT_EQ(end.not_repeated.size(), 1u);
  EXPECT_EQ(end.not_repeated[0].run, 3);
  ASSERT_EQ(end.not_repeated[0].cells.size(), 1u);
  EXPECT_EQ(end.not_repeated[0].cells[0].column, "images");
}

TEST_F(RunLogsTest, ALostSecondSimulationLeavesNoLogAndIsMadeUp) {
  const ShardEnd end = Run({-1, 0, true}, 4, /*drifts=*/false, /*dies=*/true);
  ASSERT_EQ(end.not_repeated.size(), 1u);
  EXPECT_TRUE(end.not_repeated[0].cells.empty());
  EXPECT_TRUE(end.complete());
  EXPECT_TRUE(Logged().empty());
  EXPECT_TRUE(Run({-1, 0, true}, 4).not_repeated.empty());
  EXPECT_EQ(Logged(), std::set<std::string>{"003"});
}

}  // namespace
}  // namespace dockyard
