#include "sim/campaign/shard_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/base/text.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/merge.h"
#include "sim/log/result_row.h"
#include "sim/report/column_tables.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

const Json kHeader{{"shard", "x"}};

FinishedRun FakeFinished(int run) {
  const FinishedRuns runs = FakeResults(run);
  const auto last = static_cast<std::size_t>(run - 1);
  return {runs.results[last], runs.timings[last], runs.notes[last]};
}

FinishedRun Lost(int run) {
  FinishedRun lost = FakeFinished(run);
  lost.result.success = false;
  lost.result.outcome = kStopped;
  lost.result.measures.clear();
  lost.note = "killed by signal 9 (Killed)";
  return lost;
}

/// A results folder with shard files.
class ShardRows : public testing::Test {
 protected:
  void Write(const Shard& shard, const std::vector<FinishedRun>& runs) {
    ShardWriter writer(ShardFile(dir_.path(), shard), kHeader, columns_);
    for (const FinishedRun& run : runs) writer.Append(run);
  }
  std::vector<int> RunsRead(std::vector<std::string>* damaged = nullptr) {
    std::vector<int> runs;
    for (const RunResult& result :
         ReadShards(dir_.path(), RowCheck::OfNoCampaign(), columns_, damaged).results) {
      runs.push_back(result.run);
    }
    return runs;
  }
  std::string ErrorOfReading() {
    try {
      ReadShards(dir_.path(), RowCheck::OfNoCampaign(), columns_);
    } catch (const ResultsError& error) {
      return error.what();
    }
    return "none";
  }

  TemporaryFolder dir_;
  RowColumns columns_ = FakeColumns();
  fs::path file_ = ShardFile(dir_.path(), Shard{});
};

TEST_F(ShardRows, ReadBackToTheSameRuns) {
  FinishedRun odd = FakeFinished(4);
  odd.result.labels[0] = "wet, \"sticky\"";
  odd.note = "it said \"no\", twice";
  Write({}, {FakeFinished(3), odd, Lost(7)});
  const FinishedRuns runs = ReadShards(dir_.path(), RowCheck::OfNoCampaign(), columns_);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(CsvRow(runs.results[0], columns_), CsvRow(FakeFinished(3).result, columns_));
  EXPECT_EQ(runs.results[1].labels[0], "wet, \"sticky\"");
  EXPECT_EQ(runs.notes[1], "it said \"no\", twice");
  EXPECT_EQ(runs.results[2].outcome, kStopped);
  EXPECT_EQ(runs.timings[0].cpu_time_s, 1.5);
}

TEST_F(ShardRows, OfSeveralFilesAreInOrderOfRuns) {
  Write({1, 2}, {FakeFinished(5), FakeFinished(1), FakeFinished(3)});
  Write({2, 2}, {FakeFinished(4), FakeFinished(2)});
  EXPECT_THAT(RunsRead(), ElementsAre(1, 2, 3, 4, 5));
}

TEST_F(ShardRows, ThatWereCutOffAreLeftOutAndTheNextStandsOnALineOfItsOwn) {
  Write({}, {FakeFinished(1), FakeFinished(2)});
  const std::string whole = Slurp(file_);
  for (std::size_t cut = 2; cut < whole.size(); cut += 7) {
    WriteText(file_, whole.substr(0, whole.size() - cut));
    Write({}, {FakeFinished(3)});
    const std::vector<int> runs = RunsRead();
    ASSERT_FALSE(runs.empty()) << cut;
    EXPECT_EQ(runs.back(), 3) << cut;
    EXPECT_LT(runs.size(), 3u) << cut;
  }
}

TEST_F(ShardRows, WithAnyBitChangedAreLeftOutAndToldOf) {
  Write({}, {FakeFinished(1), FakeFinished(2), FakeFinished(4)});
  const std::string whole = Slurp(file_);
  const std::size_t from = whole.find("\n", whole.find(",2,") - 10) + 1;
  for (std::size_t bit = 8 * from; bit < 8 * (from + 120); bit += 3) {
    std::string changed = whole;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    WriteText(file_, changed);
    std::vector<std::string> damaged;
    const std::vector<int> runs = RunsRead(&damaged);
    EXPECT_EQ(runs.size(), 2u) << bit;
    EXPECT_FALSE(damaged.empty()) << bit;
  }
}

TEST_F(ShardRows, OfARunThatWasLostGiveWayToItsResult) {
  Write({1, 2}, {Lost(1), FakeFinished(1), FakeFinished(2), Lost(2), Lost(3)});
  Write({2, 2}, {FakeFinished(3)});
  for (const RunResult& result :
       ReadShards(dir_.path(), RowCheck::OfNoCampaign(), columns_).results) {
    EXPECT_FALSE(IsLost(result.outcome)) << result.run;
  }
}

TEST_F(ShardRows, OfOneRunMayDifferInTheirTimesAlone) {
  FinishedRun again = FakeFinished(1);
  again.timing.cpu_time_s = 99.0;
  Write({1, 2}, {FakeFinished(1)});
  Write({2, 2}, {again});
  EXPECT_EQ(ErrorOfReading(), "none");
  again.result.state_hash ^= 1;
  again.result.measures[0] += 1.0;
  Write({3, 3}, {again});
  EXPECT_THAT(ErrorOfReading(), HasSubstr("run 1 has two results"));
  EXPECT_THAT(ErrorOfReading(), HasSubstr("which differ in depth_m, state_hash"));
}

TEST_F(ShardRows, HaveTheColumnsOfThePage) {
  columns_ = {.labels = {"[labels]"}, .measures = {{"[measures]", "", ""}}, .outcomes = {}};
  Write({}, {});
  const std::string text = Slurp(ShardFile(dir_.path(), {}));
  const std::size_t names = text.find('\n') + 1 + std::string("12345678,").size();
  std::vector<std::string> expected;
  for (const ColumnTable& table : ColumnTables()) {
    if (table.file != "shards/K-of-N.rows") continue;
    for (const Column& column : table.columns) expected.push_back(column.name);
  }
  EXPECT_EQ(text.substr(names), CsvLine(expected) + "\n");
}

TEST_F(ShardRows, OfOtherColumnsAreRefused) {
  Write({}, {FakeFinished(1)});
  columns_.measures.pop_back();
  EXPECT_THAT(ErrorOfReading(), HasSubstr("1-of-1.rows:2: expected the columns 'run,"));
}

TEST_F(ShardRows, BelongToOneProgramAtATime) {
  const ShardWriter first(file_, kHeader, columns_);
  EXPECT_THROW(ShardWriter(file_, kHeader, columns_), FolderTaken);
  const ShardWriter other(ShardFile(dir_.path(), {1, 2}), kHeader, columns_);
}

TEST_F(ShardRows, OfAnotherFolderAreTakenOnce) {
  const TemporaryFolder other;
  for (const fs::path& dir : {dir_.path(), other.path()}) {
    WriteText(dir / "campaign.yaml", "campaign: fake\n");
    WriteText(dir / "manifest.json", R"({"format": 1, "campaign": "0", "files": {}})");
  }
  Write({1, 2}, {FakeFinished(1)});
  ShardWriter(ShardFile(other.path(), {2, 2}), kHeader, columns_).Append(FakeFinished(2));
  TakeShards(other.path(), dir_.path());
  TakeShards(other.path(), dir_.path());
  EXPECT_THAT(RunsRead(), ElementsAre(1, 2));
  ShardWriter(ShardFile(other.path(), {1, 2}), kHeader, columns_).Append(FakeFinished(3));
  EXPECT_THROW(TakeShards(other.path(), dir_.path()), FolderTaken);
  WriteText(other.path() / "manifest.json", R"({"format": 1, "campaign": "1", "files": {}})");
  EXPECT_THROW(TakeShards(other.path(), dir_.path()), FolderTaken);
}

TEST(Shard, IsReadFromItsNumberAndCount) {
  EXPECT_EQ(ShardFromText("2/4")->number, 2);
  EXPECT_EQ(ShardFromText("2/4")->count, 4);
  for (const char* text : {"", "2", "0/4", "5/4", "2/", "/4", "a/4", "2/4x", "-1/4", "2/0"}) {
    EXPECT_FALSE(ShardFromText(text)) << text;
  }
}

TEST(Shard, ShardsTogetherHaveEachRunOnce) {
  for (const int count : {1, 2, 7}) {
    for (std::int64_t index = 0; index < 40; ++index) {
      int having = 0;
      for (int number = 1; number <= count; ++number) having += Shard{number, count}.Has(index);
      EXPECT_EQ(having, 1);
    }
  }
}

}  // namespace
}  // namespace dockyard
