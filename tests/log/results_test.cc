#include "sim/log/results.h"

#include <gtest/gtest.h>

#include "sim/log/result_row.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

TEST(ResultFiles, ReadBackToTheSameRuns) {
  const TemporaryFolder folder;
  const RowColumns columns = FakeColumns();
  FinishedRuns runs = FakeResults(6);
  runs[2].result.docked = false;
  runs[2].result.outcome = kCrashed;
  runs[2].result.measures.clear();
  runs[4].result.labels[0] = "wet, \"sticky\"";
  WriteText(folder.path() / "results.csv", ResultsCsv(runs, columns));
  WriteText(folder.path() / "timing.csv", TimingCsv(runs));
  const FinishedRuns back = ReadResults(folder.path(), columns);
  EXPECT_EQ(ResultsCsv(back, columns), ResultsCsv(runs, columns));
  EXPECT_EQ(TimingCsv(back), TimingCsv(runs));
  EXPECT_EQ(back.at(4).result.labels[0], "wet, \"sticky\"");
  EXPECT_TRUE(back.at(2).result.measures.empty());
}

TEST(ResultFiles, LeaveOutALastLineThatWasCutOff) {
  const TemporaryFolder folder;
  const FinishedRuns runs = FakeResults(6);
  const std::string csv = ResultsCsv(runs, FakeColumns());
  for (const std::size_t cut : {1u, 5u, 60u}) {  // 1: the newline alone is missing
    WriteText(folder.path() / "results.csv", csv.substr(0, csv.size() - cut));
    EXPECT_EQ(ReadResults(folder.path(), FakeColumns()).size(), runs.size() - 1) << cut;
  }
}

std::string ErrorOf(const std::filesystem::path& dir, const RowColumns& columns) {
  try {
    ReadResults(dir, columns);
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "none";
}

TEST(ResultFiles, PointAtALineThatIsNotARow) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "results.csv").string();
  WriteText(file, CsvHeader(FakeColumns()) + "\n1,2,three\n");
  EXPECT_EQ(ErrorOf(folder.path(), FakeColumns()), file + ":2: not a row of " + file);
}

TEST(ResultFiles, OfOtherColumnsAreRefused) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "results.csv").string();
  WriteText(file, ResultsCsv(FakeResults(2), FakeColumns()));
  RowColumns others = FakeColumns();
  others.labels[0] = "ground";
  EXPECT_EQ(ErrorOf(folder.path(), others),
            file + ":1: expected the columns '" + CsvHeader(others) + "'");
}

TEST(ResultFiles, AreNoRunsWhenThereAreNone) {
  const TemporaryFolder folder;
  EXPECT_TRUE(ReadResults(folder.path(), FakeColumns()).empty());
}

}  // namespace
}  // namespace dockyard
