// A results folder that a stranger made: nothing outside of it is read, written or emptied, nothing
// hangs, and no row counts that the campaign did not plan.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "sim/base/folder.h"
#include "sim/campaign/campaign.h"
#include "sim/campaign/database.h"
#include "support/fake_campaign.h"
#include "support/fake_runs.h"
#include "support/run_campaign.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

constexpr int kRuns = 3;

class Stranger : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(user_ / "001");
    WriteText(user_ / "001/photo", "precious");
    WriteText(user_ / "file", "precious");
  }
  void TearDown() override {
    EXPECT_EQ(Slurp(user_ / "001/photo"), "precious");
    EXPECT_EQ(Slurp(user_ / "file"), "precious");
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(user_), {}), 3);
  }

  void Run() const {
    CampaignOptions options;
    options.out_dir = out_;
    options.systems = FakeSystems();
    options.columns = FakeColumns();
    options.identity.campaign_yaml = CampaignYaml(campaign_);
    RunCampaign(
        campaign_, [](const CampaignRun& run, const RunLogging&) { return FakeRecord(run); },
        options);
  }
  void LinkInPlaceOf(const fs::path& place, const fs::path& target) const {
    fs::remove_all(out_ / place);
    fs::create_directories((out_ / place).parent_path());
    fs::create_symlink(target, out_ / place);
  }
  static std::string Refusal(const std::function<void()>& action) {
    try {
      action();
    } catch (const UnsafeContent& error) {
      return error.what();
    } catch (const ResultsError& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryFolder folder_;
  fs::path out_ = folder_.path() / "out", user_ = folder_.path() / "user";
  Campaign campaign_ = FakeCampaign(kRuns);
};

TEST_F(Stranger, CannotLinkAFolderToOneOutside) {
  for (const char* part : {"files", "shards", "runs", "sightings", "plots", "work", "submit"}) {
    fs::remove_all(out_);
    Run();
    LinkInPlaceOf(part, user_);
    EXPECT_THAT(Refusal([&] { Run(); }), HasSubstr("found a link; remove it")) << part;
    EXPECT_NE(Refusal([&] { TakeShards(out_, folder_.path() / "all"); }), "none") << part;
    EXPECT_FALSE(fs::exists(folder_.path() / "all")) << part;
  }
}

TEST_F(Stranger, CannotLinkAFileToOneOutside) {
  for (const char* file :
       {"manifest.json", "campaign.yaml", "shards/1-of-1.rows", "shards/1-of-1.lock"}) {
    fs::remove_all(out_);
    Run();
    LinkInPlaceOf(file, user_ / "file");
    EXPECT_THAT(Refusal([&] { Run(); }), HasSubstr("found a link; remove it")) << file;
  }
}

TEST_F(Stranger, TablesTakeThePlaceOfLinksThatHaveTheirNames) {
  Run();
  for (const char* file : {"results.csv", "timing.csv", "results.sqlite", "summary.txt"}) {
    LinkInPlaceOf(file, user_ / "file");
  }
  MergeShards(out_, campaign_, FakeColumns());
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(out_ / "results.csv")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(out_ / "results.sqlite")));
}

TEST_F(Stranger, EndsNoReaderWithAPipeOrAnEndlessFile) {
  Run();
  fs::remove(out_ / "manifest.json");
  ASSERT_EQ(::mkfifo((out_ / "manifest.json").c_str(), 0600), 0);
  EXPECT_THAT(Refusal([&] { HoldsCampaign(out_); }), HasSubstr("found a pipe"));
  LinkInPlaceOf("manifest.json", "/dev/zero");
  EXPECT_THAT(Refusal([&] { HoldsCampaign(out_); }), HasSubstr("found a link"));
  fs::remove(out_ / "manifest.json");
  WriteText(out_ / "manifest.json", "");
  fs::resize_file(out_ / "manifest.json", kMostManifestBytes + 1);  // sparse
  EXPECT_THAT(Refusal([&] { Run(); }), HasSubstr("at most 64 MiB"));
}

TEST_F(Stranger, GivesNoFileOutsideToAMerge) {
  Run();
  fs::create_symlink(user_ / "file", out_ / "runs/001/notes");
  EXPECT_THAT(Refusal([&] { TakeShards(out_, folder_.path() / "all"); }),
              HasSubstr("runs/001/notes: expected a file or a folder, found a link"));
  EXPECT_FALSE(fs::exists(folder_.path() / "all"));
}

TEST_F(Stranger, TheFolderItselfMayBeALink) {
  fs::create_directories(folder_.path() / "disk");
  fs::create_directory_symlink(folder_.path() / "disk", out_);
  Run();
  Run();
  EXPECT_TRUE(fs::exists(folder_.path() / "disk/results.csv"));
}

TEST_F(Stranger, RemovesLinksButNotTheirTargets) {
  Run();
  fs::create_symlink(user_, out_ / "runs/001/more");
  Folder(out_).Remove("runs/001");
  EXPECT_FALSE(fs::exists(out_ / "runs/001"));
}

/// A row as the run's own, but for one part.
class ForgedRow : public Stranger {
 protected:
  std::string RefusalOf(const std::function<void(RunResult&)>& forge) {
    FinishedRun run;
    run.result = FakeResults(2).results[1];
    forge(run.result);
    fs::remove_all(out_);
    const RowColumns columns = FakeColumns();
    ShardWriter(ShardFile(out_, Shard{}), {{"shard", "x"}}, columns).Append(run);
    return Refusal([&] { ReadShards(out_, RowCheck(campaign_), FakeColumns()); });
  }
};

TEST_F(ForgedRow, OfARunThatIsNotPlannedIsRefused) {
  EXPECT_EQ(RefusalOf([](RunResult&) {}), "none");
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.run = 1000; }),
              HasSubstr("run 1000 does not belong to this campaign: it has no run of that number"));
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.run = 0; }), HasSubstr("does not belong"));
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.run = -1; }), HasSubstr("does not belong"));
}

TEST_F(ForgedRow, WithAnotherSeedOrLabelIsRefused) {
  EXPECT_THAT(RefusalOf([](RunResult& row) { ++row.seed; }), HasSubstr("its seed is"));
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.labels[0] = "wet"; }), HasSubstr("its labels"));
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.labels[1] = "2"; }), HasSubstr("its labels"));
}

TEST_F(ForgedRow, OfASealedCampaignIsCheckedByWhatIsKnownWithoutTheSecret) {
  campaign_.sealed_sha256 = "of a secret that is not known";
  EXPECT_EQ(RefusalOf([](RunResult& row) { ++row.seed; }), "none");
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.labels[0] = "wet"; }), HasSubstr("its labels"));
  EXPECT_THAT(RefusalOf([](RunResult& row) { row.run = 99; }), HasSubstr("no run"));
}

TEST(Merges, AtOnceAllEndWithTheSameTables) {
  const TemporaryFolder folder;
  const Campaign campaign = FakeCampaign(kRuns);
  const RowColumns columns = FakeColumns();
  ShardWriter rows(ShardFile(folder.path(), Shard{}), {{"shard", "x"}}, columns);
  const FinishedRuns runs = FakeResults(kRuns);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    rows.Append({runs.results[i], runs.timings[i], runs.notes[i]});
  }
  WriteText(folder.path() / "manifest.json", R"({"format": 1})");
  MergeShards(folder.path(), campaign, FakeColumns());
  const std::string database = Slurp(folder.path() / "results.sqlite");
  std::vector<pid_t> programs;
  for (int i = 0; i < 6; ++i) {
    const pid_t child = ::fork();
    if (child == 0) {
      try {
        for (int times = 0; times < 5; ++times) {
          MergeShards(folder.path(), campaign, FakeColumns());
          WriteDatabase(folder.path() / "other.sqlite", runs, FakeColumns());  // without a lock
        }
        ::_exit(0);
      } catch (const std::exception&) {
        ::_exit(50);
      }
    }
    programs.push_back(child);
  }
  for (const pid_t program : programs) {
    int status = 0;
    ::waitpid(program, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(Slurp(folder.path() / "results.sqlite"), database);
  EXPECT_EQ(Slurp(folder.path() / "other.sqlite"), database);
}

}  // namespace
}  // namespace dockyard
