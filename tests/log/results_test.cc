#include "sim/log/results.h"

#include <gtest/gtest.h>

#include "sim/log/result_row.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

/// results.csv of the runs.
std::string ResultsText(const FinishedRuns& runs) {
  const TemporaryFolder folder;
  WriteResultsCsv(folder.path() / "results.csv", runs, FakeColumns());
  return Slurp(folder.path() / "results.csv");
}

TEST(ResultFiles, HoldNoFormulaOfASpreadsheetAndReadBackToTheSameText) {
  const std::vector<std::string> texts{
      "=1+1", "@SUM(1)", "+1", "-x",      "\t=1", "=A1,\"b\"", "'=1+1", "''-x", "-1.5",
      "'-1",  "-inf",    "-",  "'quoted", "",     "it's =1+1", "'",     "1e-3", "+"};
  FinishedRuns runs = FakeResults(static_cast<int>(texts.size()));
  for (std::size_t i = 0; i < texts.size(); ++i) runs.results[i].labels[0] = texts[i];
  const std::string file = ResultsText(runs);
  for (const char* formula : {",=", ",@", ",+", ",-x", ",\t", ",\"=", ",\"\t"}) {
    EXPECT_EQ(file.find(formula), std::string::npos) << formula;
  }
  EXPECT_NE(file.find(",-1.5,"), std::string::npos) << "a number stays as it is";
  const auto back = RowsFromCsv(file, "results.csv", FakeColumns());
  ASSERT_EQ(back.size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(back[i].labels[0], texts[i]);
}

TEST(ResultFiles, ReadBackToTheSameRuns) {
  FinishedRuns runs = FakeResults(6);
  runs.results[1].success = false;
  runs.results[1].outcome = kCrashed;
  runs.results[1].measures.clear();
  runs.results[2].success = false;
  runs.results[2].outcome = kStopped;
  runs.results[2].measures.clear();
  runs.results[3].labels[0] = "wet, \"sticky\"";
  const auto back = RowsFromCsv(ResultsText(runs), "results.csv", FakeColumns());
  ASSERT_EQ(back.size(), 6u);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(CsvRow(back[i], FakeColumns()), CsvRow(runs.results[i], FakeColumns()));
  }
  EXPECT_EQ(back[3].labels[0], "wet, \"sticky\"");
  EXPECT_TRUE(back[1].measures.empty());
}

TEST(ResultFiles, HaveALineForEachRunsTimes) {
  const TemporaryFolder folder;
  WriteTimingCsv(folder.path() / "timing.csv", FakeResults(2));
  EXPECT_EQ(Slurp(folder.path() / "timing.csv"),
            "run,cpu_time_s,wall_time_s,controller_cpu_s,controller_wall_s\n"
            "1,1.5,2.5,0.5,0.75\n2,1.5,2.5,0.5,0.75\n");
}

TEST(ResultFiles, LeaveOutALastLineThatWasCutOff) {
  const std::string csv = ResultsText(FakeResults(6));
  for (const std::size_t cut : {1u, 5u, 60u}) {  // 1: the newline alone is missing
    const auto rows = RowsFromCsv(csv.substr(0, csv.size() - cut), "results.csv", FakeColumns());
    EXPECT_EQ(rows.size(), 5u) << cut;
  }
}

std::string ErrorOf(const std::string& csv, const RowColumns& columns) {
  try {
    RowsFromCsv(csv, "r.csv", columns);
  } catch (const ResultsError& error) {
    return error.what();
  }
  return "none";
}

TEST(ResultFiles, PointAtALineThatIsNotARow) {
  EXPECT_EQ(ErrorOf(CsvHeader(FakeColumns()) + "\n1,2,three\n", FakeColumns()),
            "r.csv:2: not a row of r.csv");
}

TEST(ResultFiles, OfOtherColumnsAreRefused) {
  RowColumns others = FakeColumns();
  others.labels[0] = "ground";
  EXPECT_EQ(ErrorOf(ResultsText(FakeResults(2)), others),
            "r.csv:1: expected the columns '" + CsvHeader(others) + "'");
}

TEST(FinishedRuns, AreFoundByTheirNumbers) {
  const FinishedRuns runs = FakeResults(5);
  for (int run = 1; run <= 5; ++run) {
    EXPECT_EQ(runs.Find(run), static_cast<std::size_t>(run - 1));
  }
  for (const int run : {-1, 0, 6}) EXPECT_EQ(runs.Find(run), runs.size());
  EXPECT_EQ(FinishedRuns().Find(1), 0u);
}

}  // namespace
}  // namespace dockyard
