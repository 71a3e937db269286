#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

#include "models/read/config_error.h"
#include "sim/campaign/campaign.h"
#include "sim/log/result_row.h"
#include "sim/log/run_log.h"
#include "sim/scenario/key_path.h"
#include "support/fake_campaign.h"
#include "support/fake_runs.h"
#include "support/run_campaign.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

CampaignOptions OptionsFor(const fs::path& dir, int jobs) {
  CampaignOptions options;
  options.out_dir = dir;
  options.jobs = jobs;
  options.systems = FakeSystems();
  options.columns = FakeColumns();
  options.identity.campaign_yaml = CampaignYaml(FakeCampaign(3));
  return options;
}

/// FakeRecord, later for runs of odd number, so that runs do not end in order.
RunRecord FakeRun(const CampaignRun& run, const RunLogging&) {
  std::this_thread::sleep_for(std::chrono::milliseconds(run.run % 2 == 1 ? 30 : 1));
  return FakeRecord(run);
}

/// Every file that must not depend on how the campaign came to its end.
void ExpectSameResults(const fs::path& a, const fs::path& b) {
  for (const char* file :
       {"results.csv", "results.sqlite", "summary.txt", "campaign.yaml", "runs/003/history.csv",
        "runs/003/outcome.json", "runs/003/plans.json", "runs/003/sightings.json"}) {
    EXPECT_EQ(Slurp(a / file), Slurp(b / file)) << file;
  }
}

/// Runs the campaign in a process of its own; the test may do to it what it likes.
pid_t StartCampaignProcess(const fs::path& dir, int count, int jobs, int pause_ms) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const auto slow = [pause_ms](const CampaignRun& run, const RunLogging&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    return FakeRun(run, {});
  };
  const CampaignOptions options = OptionsFor(dir, jobs);
  const int signal = RunShard(FakeCampaign(count), slow, options).signal;
  MergeShards(dir, FakeCampaign(count), options.columns);
  ::_exit(signal != 0 ? 128 + signal : 0);
}

int LinesIn(const fs::path& file) {
  if (!fs::exists(file)) return 0;
  const std::string text = Slurp(file);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// Rows of the folder's only shard; its first two lines are no rows.
int RowsIn(const fs::path& dir) { return LinesIn(ShardFile(dir, Shard{})) - 2; }

void WaitForRows(const fs::path& dir, int rows) {
  for (int i = 0; i < 2000 && RowsIn(dir) < rows; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

const RunResult& ResultOf(const CampaignEnd& end, int run) {
  return end.runs.results.at(end.runs.Find(run));
}
const std::string& NoteOf(const CampaignEnd& end, int run) {
  return end.runs.notes.at(end.runs.Find(run));
}

TEST(RunCampaign, GivesTheSameBytesForAnyNumberOfProcesses) {
  const TemporaryFolder folder;
  for (const int jobs : {1, 2, 3}) {
    const auto end = RunCampaign(FakeCampaign(8), FakeRun,
                                 OptionsFor(folder.path() / std::to_string(jobs), jobs));
    EXPECT_TRUE(end.complete());
  }
  ExpectSameResults(folder.path() / "1", folder.path() / "2");
  ExpectSameResults(folder.path() / "1", folder.path() / "3");
}

TEST(RunCampaign, KeepsARunThatDiesToItself) {
  const TemporaryFolder folder;
  const auto dies = [](const CampaignRun& run, const RunLogging&) -> RunRecord {
    if (run.run == 2) {
      ::signal(SIGSEGV, SIG_DFL);
      ::raise(SIGSEGV);
    }
    if (run.run == 3) ::_exit(9);
    if (run.run == 4) throw std::runtime_error("the renderer found no context");
    return FakeRun(run, {});
  };
  const CampaignEnd end = RunCampaign(FakeCampaign(5), dies, OptionsFor(folder.path(), 2));
  ASSERT_TRUE(end.complete());
  for (const int run : {2, 3, 4}) {
    EXPECT_EQ(ResultOf(end, run).outcome, kCrashed);
    EXPECT_TRUE(ResultOf(end, run).measures.empty());
    EXPECT_EQ(ResultOf(end, run).labels, FakeRuns(5)[run - 1].labels);
    EXPECT_EQ(ResultOf(end, run).seed, FakeRuns(5)[run - 1].scenario.seed.number);
  }
  EXPECT_EQ(ResultOf(end, 1).outcome, "docked");
  EXPECT_EQ(ResultOf(end, 5).outcome, "docked");
  EXPECT_THAT(end.summary, HasSubstr("killed by signal 11 (Segmentation fault)"));
  EXPECT_THAT(end.summary, HasSubstr("ended with exit code 9 before its result"));
  EXPECT_THAT(end.summary, HasSubstr("threw: the renderer found no context"));
}

TEST(RunCampaign, ClosesTheLogOfARunThatWasKilled) {
  const TemporaryFolder folder;
  const auto dies = [](const CampaignRun& run, const RunLogging& logging) -> RunRecord {
    RunLogWriter log(logging.dir, {.run = run.run, .system = "toy", .nominal = {}});
    for (Tick tick = 0; tick <= 2500; tick += 20) log.Append(SensorFrame{.tick = tick}, {});
    if (run.run == 2) ::raise(SIGKILL);
    log.Finish();
    return FakeRun(run, {});
  };
  RunCampaign(FakeCampaign(3), dies, OptionsFor(folder.path(), 1));
  RunLogReader log(folder.path() / "runs" / "002");
  Tick last = -1;
  while (const auto entry = log.Next()) last = entry->sensed.tick;
  EXPECT_TRUE(log.complete());
  EXPECT_EQ(last, 1980);  // two chunks of a second; the third was under way
}

TEST(RunCampaign, KillsARunThatHangs) {
  const TemporaryFolder folder;
  const auto hangs = [](const CampaignRun& run, const RunLogging&) {
    while (run.run == 1) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return FakeRun(run, {});
  };
  const CampaignOptions options = OptionsFor(folder.path(), 2);
  Campaign campaign = FakeCampaign(3);
  campaign.limits.wall_s = 1.0;
  const CampaignEnd end = RunCampaign(campaign, hangs, options);
  EXPECT_EQ(ResultOf(end, 1).outcome, kStopped);
  EXPECT_TRUE(ResultOf(end, 2).success);
  EXPECT_THAT(end.summary, HasSubstr("killed: it took more than 1 s of wall time"));
}

TEST(RunCampaign, KeepsWhatARunPrintsOutOfTheWay) {
  const TemporaryFolder folder;
  const auto prints = [](const CampaignRun& run, const RunLogging&) {
    if (run.run == 1) std::printf("a word to stdout\n");
    if (run.run == 1) std::fprintf(stderr, "a word to stderr\n");
    return FakeRun(run, {});
  };
  ::testing::internal::CaptureStdout();
  RunCampaign(FakeCampaign(2), prints, OptionsFor(folder.path(), 1));
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_THAT(Slurp(folder.path() / "runs/001/messages.txt"), HasSubstr("a word to stdout"));
  EXPECT_THAT(Slurp(folder.path() / "runs/001/messages.txt"), HasSubstr("a word to stderr"));
  EXPECT_FALSE(fs::exists(folder.path() / "runs/002/messages.txt"));
}

TEST(RunCampaign, KilledInTheMiddleGoesOnToTheSameResults) {
  const TemporaryFolder folder;
  const fs::path stopped = folder.path() / "stopped", straight = folder.path() / "straight";
  const pid_t child = StartCampaignProcess(stopped, 8, 2, 60);
  WaitForRows(stopped, 3);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const int kept = RowsIn(stopped);
  ASSERT_GE(kept, 3);
  ASSERT_LT(kept, 8);
  int run_now = 0;
  for (const auto& entry : fs::directory_iterator(stopped / "runs")) run_now += entry.exists();
  const CampaignEnd end = RunCampaign(FakeCampaign(8), FakeRun, OptionsFor(stopped, 2));
  EXPECT_TRUE(end.complete());
  RunCampaign(FakeCampaign(8), FakeRun, OptionsFor(straight, 1));
  ExpectSameResults(stopped, straight);
  EXPECT_GE(run_now, kept);
}

TEST(RunCampaign, RunsNoFinishedRunAgain) {
  const TemporaryFolder folder;
  RunCampaign(FakeCampaign(3), FakeRun, OptionsFor(folder.path(), 1));
  const auto never = [](const CampaignRun&, const RunLogging&) -> RunRecord {
    throw std::runtime_error("ran again");
  };
  const CampaignEnd end = RunCampaign(FakeCampaign(3), never, OptionsFor(folder.path(), 1));
  EXPECT_TRUE(end.complete());
  EXPECT_TRUE(ResultOf(end, 1).success);
}

TEST(RunCampaign, RunsARunAgainWhoseRowIsDamaged) {
  const TemporaryFolder folder;
  RunCampaign(FakeCampaign(4), FakeRun, OptionsFor(folder.path(), 1));
  const std::string csv = Slurp(folder.path() / "results.csv");
  const fs::path shard = ShardFile(folder.path(), Shard{});
  std::string rows = Slurp(shard);
  rows[rows.find("docked", rows.find("\n", rows.find(",2,"))) + 1] ^= 1;
  WriteText(shard, rows.substr(0, rows.size() - 7));  // and the last is cut off
  const CampaignEnd end = RunCampaign(FakeCampaign(4), FakeRun, OptionsFor(folder.path(), 1));
  EXPECT_TRUE(end.complete());
  EXPECT_FALSE(end.damaged.empty());
  EXPECT_EQ(Slurp(folder.path() / "results.csv"), csv);
}

TEST(RunCampaign, GivesTheSameBytesInShards) {
  const TemporaryFolder folder;
  const Campaign campaign = FakeCampaign(11);
  const fs::path serial = folder.path() / "serial", shards = folder.path() / "shards";
  RunCampaign(campaign, FakeRun, OptionsFor(serial, 1));
  CampaignOptions options = OptionsFor(shards, 2);
  for (const int number : {3, 1, 2}) {
    options.shard = {number, 3};
    const ShardEnd end = RunShard(campaign, FakeRun, options);
    EXPECT_TRUE(end.complete());
    EXPECT_EQ(end.total, number == 3 ? 3 : 4);
  }
  MergeShards(shards, campaign, options.columns);
  ExpectSameResults(serial, shards);
}

TEST(RunCampaign, TriesALostRunAgainAndRetriesLostOnesWhenAsked) {
  const TemporaryFolder folder;
  const fs::path well = folder.path() / "well", out = folder.path() / "out";
  const auto sick = [&](const CampaignRun& run, const RunLogging&) -> RunRecord {
    if (run.run == 2 && !fs::exists(well)) ::kill(::getpid(), SIGKILL);
    return FakeRun(run, {});
  };
  const CampaignEnd lost = RunCampaign(FakeCampaign(3), sick, OptionsFor(out, 1));
  EXPECT_EQ(ResultOf(lost, 2).outcome, kStopped);
  EXPECT_THAT(NoteOf(lost, 2), HasSubstr("killed by signal 9"));
  WriteText(well, "");
  EXPECT_EQ(ResultOf(RunCampaign(FakeCampaign(3), sick, OptionsFor(out, 1)), 2).outcome, kStopped);
  CampaignOptions again = OptionsFor(out, 1);
  again.retry_lost = true;
  EXPECT_TRUE(ResultOf(RunCampaign(FakeCampaign(3), sick, again), 2).success);
  const fs::path straight = folder.path() / "straight";
  RunCampaign(FakeCampaign(3), FakeRun, OptionsFor(straight, 1));
  ExpectSameResults(out, straight);
}

TEST(RunCampaign, StopsInOrderOfRunsWhenItHasEnough) {
  const TemporaryFolder folder;
  for (const int jobs : {1, 3}) {
    std::vector<int> seen;
    CampaignOptions options = OptionsFor(folder.path() / std::to_string(jobs), jobs);
    options.enough = [&](const RunResult& result) {
      seen.push_back(result.run);
      return seen.size() == 5;
    };
    const ShardEnd end = RunShard(FakeCampaign(20), FakeRun, options);
    EXPECT_TRUE(end.enough);
    EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4, 5}));
    EXPECT_LT(end.tally.done, 5 + 2 * jobs);
    seen.clear();
    RunShard(FakeCampaign(20), FakeRun, options);  // the earlier results are enough
    EXPECT_EQ(seen, (std::vector<int>{1, 2, 3, 4, 5}));
  }
}

TEST(RunCampaign, KeepsTheLogsThatTheCampaignAsksFor) {
  const TemporaryFolder folder;
  Campaign campaign = FakeCampaign(12);  // runs 3, 6, 9, 12 miss
  campaign.keep = {2, 0, true};
  RunCampaign(campaign, FakeRun, OptionsFor(folder.path(), 3));
  std::set<std::string> kept;
  for (const auto& entry : fs::directory_iterator(folder.path() / "runs")) {
    kept.insert(entry.path().filename().string());
  }
  EXPECT_EQ(kept, (std::set<std::string>{"003", "006"}));
  EXPECT_FALSE(fs::exists(folder.path() / "work"));
}

TEST(RunCampaign, KeepsWhatIsDoneOnCtrlC) {
  const TemporaryFolder folder;
  const pid_t child = StartCampaignProcess(folder.path(), 20, 2, 60);
  WaitForRows(folder.path(), 3);
  const auto asked = std::chrono::steady_clock::now();
  ::kill(child, SIGINT);
  int status = 0;
  ::waitpid(child, &status, 0);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - asked;
  EXPECT_LT(took.count(), 2.0);
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const int kept = RowsIn(folder.path());
  EXPECT_GE(kept, 3);
  EXPECT_LT(kept, 20);
  EXPECT_THAT(Slurp(folder.path() / "summary.txt"),
              HasSubstr("incomplete: " + std::to_string(kept) + " of 20 runs"));
}

TEST(RunCampaign, LeavesNoWorkerBehindWhenKilled) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  const pid_t child = ::fork();
  if (child == 0) {
    const auto forever = [&](const CampaignRun&, const RunLogging&) -> RunRecord {
      for (;;) {
        WriteText(alive, "x");
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    };
    RunCampaign(FakeCampaign(1), forever, OptionsFor(folder.path() / "out", 1));
    ::_exit(0);
  }
  for (int i = 0; i < 1000 && !fs::exists(alive); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ASSERT_TRUE(fs::exists(alive));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  fs::remove(alive);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(fs::exists(alive));
}

TEST(RunCampaign, WithoutLogsLeavesNoFolderOfARun) {
  const TemporaryFolder folder;
  Campaign campaign = FakeCampaign(3);
  campaign.keep = Keep::None();
  const auto run = [](const CampaignRun& what, const RunLogging& logging) -> RunRecord {
    EXPECT_TRUE(logging.dir.empty());
    if (what.run == 2) throw std::runtime_error("no context");
    return FakeRun(what, {});
  };
  const CampaignEnd end = RunCampaign(campaign, run, OptionsFor(folder.path(), 2));
  EXPECT_TRUE(end.complete());
  EXPECT_EQ(ResultOf(end, 2).outcome, kCrashed);
  EXPECT_EQ(NoteOf(end, 2), "threw: no context");
  EXPECT_FALSE(fs::exists(folder.path() / "runs"));
  EXPECT_FALSE(fs::exists(folder.path() / "work"));
}

TEST(RunCampaign, SumsUpAGridPointByPoint) {
  const TemporaryFolder folder;
  Campaign campaign = FakeCampaign(1);
  campaign.table = {};
  campaign.tags.clear();
  campaign.grid = {
      {{"start.r_m", {}}, {"2", "3"}, {ScalarNode("2", false), ScalarNode("3", false)}}};
  campaign.repeats = 2;
  campaign.labels = {"point", "repeat", "start.r_m"};
  campaign.figures = {.x = "start.r_m", .measures = {"success"}};
  CampaignOptions options = OptionsFor(folder.path(), 2);
  options.columns.labels = campaign.labels;
  const auto run = [&](const CampaignRun& what, const RunLogging&) {
    RunRecord record = FakeRun(what, {});
    record.columns = options.columns;
    return record;
  };
  EXPECT_TRUE(RunCampaign(campaign, run, options).complete());
  EXPECT_THAT(Slurp(folder.path() / "points.csv"), HasSubstr("start.r_m,runs,success,"));
  EXPECT_THAT(Slurp(folder.path() / "points.csv"), HasSubstr("\n2,2,1,"));
  EXPECT_THAT(Slurp(folder.path() / "points.csv"), HasSubstr("\n3,2,0.5,"));  // run 3 misses
  EXPECT_THAT(Slurp(folder.path() / "plots/curves.svg"), HasSubstr("fake, 4 runs"));
}

TEST(RunCampaign, TellsANoteOfSeveralLinesInOne) {
  const TemporaryFolder folder;
  const auto run = [](const CampaignRun& what, const RunLogging&) {
    RunRecord record = FakeRun(what, {});
    record.failure_note = "first\nsecond";
    return record;
  };
  const CampaignEnd end = RunCampaign(FakeCampaign(3), run, OptionsFor(folder.path(), 1));
  EXPECT_EQ(NoteOf(end, 3), "first second");
  EXPECT_EQ(NoteOf(end, 1), "");  // a success
  EXPECT_THAT(end.summary, HasSubstr("\n     first second\n"));
}

TEST(RunCampaign, LosesOnlyTheRunThatDrewWhatCannotBeSimulated) {
  const TemporaryFolder folder;
  const auto bad = [](const CampaignRun& run, const RunLogging&) {
    if (run.run == 3) throw ConfigError("axel.yaml:14:9: wheels.radius_m: expected a number > 0");
    return FakeRun(run, {});
  };
  const CampaignEnd end = RunCampaign(FakeCampaign(4), bad, OptionsFor(folder.path(), 1));
  EXPECT_EQ(RowsIn(folder.path()), 4);
  EXPECT_EQ(NoteOf(end, 3), "refused: axel.yaml:14:9: wheels.radius_m: expected a number > 0");
}

TEST(RunCampaign, EndsWhenARunCannotWrite) {
  const TemporaryFolder folder;
  const auto full = [](const CampaignRun& run, const RunLogging&) {
    if (run.run == 2) throw IoError("cannot write run.mcap: No space left on device");
    return FakeRun(run, {});
  };
  EXPECT_THROW(RunCampaign(FakeCampaign(3), full, OptionsFor(folder.path(), 1)), IoError);
  EXPECT_EQ(RowsIn(folder.path()), 1);
}

}  // namespace
}  // namespace dockyard
