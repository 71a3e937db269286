#include "sim/campaign/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cmath>
#include <limits>

#include "campaign/fake_runs.h"
#include "sim/campaign/database.h"
#include "sim/log/files.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RunResult SomeRow() {
  RunResult row = FakeRecord(FakeCampaign(5).runs[4]).result;
  row.seed = 0xfedcba9876543210ull;  // beyond 2^63
  row.state_hash = 0x00000000000000afull;
  row.lateral_error_m = -0.0;
  row.yaw_error_deg = 5e-324;
  row.region = "in, \"quotes\"";
  return row;
}

FinishedRuns SomeRuns() {
  FinishedRuns runs;
  for (const CampaignRun& run : FakeCampaign(6).runs) {
    const RunRecord record = FakeRecord(run);
    runs[run.run] = {record.result, record.timing};
  }
  return runs;
}

TEST(ResultRow, HasTheColumnsOfTheContractInTheirOrder) {
  EXPECT_EQ(CsvHeader(),
            "run,seed,controller,region,day,soil,light,r_m,alpha_deg,heading_deg,docked,outcome,"
            "sim_time_s,image_pairs,recoveries,tip_depth_m,lateral_error_m,yaw_error_deg,"
            "station_shift_m,cone_force_peak_n,spool_current_mean_a,spool_current_peak_a,"
            "wheel_current_mean_a,wheel_current_peak_a,state_hash");
}

TEST(ResultRow, ReadsBackToTheSameBits) {
  const RunResult row = SomeRow();
  const auto back = RowFromCsv(CsvRow(row));
  ASSERT_TRUE(back.has_value());
  EXPECT_THAT(DifferingColumns(row, *back), IsEmpty());
  EXPECT_TRUE(std::signbit(back->lateral_error_m));
  EXPECT_EQ(back->yaw_error_deg, 5e-324);
  EXPECT_EQ(back->cone_force_peak_n, row.cone_force_peak_n);
}

TEST(ResultRow, WritesTheStateHashAsSixteenHexDigits) {
  EXPECT_THAT(CsvRow(SomeRow()), ::testing::EndsWith(",00000000000000af"));
}

TEST(ResultRow, TellsWhichColumnsDiffer) {
  const RunResult row = SomeRow();
  RunResult other = row;
  other.state_hash ^= 1;
  other.tip_depth_m = std::nextafter(row.tip_depth_m, 1.0);
  EXPECT_THAT(DifferingColumns(row, other), ElementsAre("tip_depth_m", "state_hash"));
}

TEST(ResultRow, RefusesALineThatIsNotOneWholeRow) {
  const std::string line = CsvRow(FakeRecord(FakeCampaign(1).runs[0]).result);
  ASSERT_TRUE(RowFromCsv(line).has_value());
  for (std::size_t length = 0; length < line.size(); ++length) {
    EXPECT_FALSE(RowFromCsv(line.substr(0, length)).has_value()) << length;
  }
  EXPECT_FALSE(RowFromCsv(line + ",1").has_value());
}

TEST(ResultRow, KeepsTheTablesDegreesAsTheyWere) {
  CampaignRun run = FakeCampaign(1).runs[0];
  run.scenario.start.alpha_rad = Radians(15.0);
  run.scenario.start.heading_rad = Radians(-22.4);
  EXPECT_EQ(StartOfRow(run).alpha_deg, 15.0);
  EXPECT_EQ(StartOfRow(run).heading_deg, -22.4);
}

TEST(ResultFiles, ReadBackToTheSameRuns) {
  const TemporaryFolder folder;
  const FinishedRuns runs = SomeRuns();
  WriteText(folder.path() / "results.csv", ResultsCsv(runs));
  WriteText(folder.path() / "timing.csv", TimingCsv(runs));
  const FinishedRuns back = ReadResults(folder.path());
  EXPECT_EQ(ResultsCsv(back), ResultsCsv(runs));
  EXPECT_EQ(TimingCsv(back), TimingCsv(runs));
}

TEST(ResultFiles, LeaveOutALastLineThatWasCutOff) {
  const TemporaryFolder folder;
  const FinishedRuns runs = SomeRuns();
  const std::string csv = ResultsCsv(runs);
  for (const std::size_t cut : {1u, 5u, 60u}) {  // 1: the newline alone is missing
    WriteText(folder.path() / "results.csv", csv.substr(0, csv.size() - cut));
    EXPECT_EQ(ReadResults(folder.path()).size(), runs.size() - 1) << cut;
  }
}

TEST(ResultFiles, PointAtALineThatIsNotARow) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "results.csv").string();
  WriteText(file, CsvHeader() + "\n1,2,three\n" + CsvRow(SomeRow()) + "\n");
  try {
    ReadResults(folder.path());
    FAIL() << "a broken row was read";
  } catch (const ResultsError& error) {
    EXPECT_EQ(std::string(error.what()), file + ":2: not a row of " + file);
  }
}

TEST(ResultFiles, AreNoRunsWhenThereAreNone) {
  const TemporaryFolder folder;
  EXPECT_TRUE(ReadResults(folder.path()).empty());
}

/// REAL columns are compared as numbers: SQLite prints 15 digits only.
void ExpectTableEquals(sqlite3* database, const FinishedRuns& runs) {
  sqlite3_stmt* query = nullptr;
  ASSERT_EQ(sqlite3_prepare_v2(database, "SELECT * FROM runs ORDER BY run", -1, &query, nullptr),
            SQLITE_OK);
  for (const auto& [number, run] : runs) {
    ASSERT_EQ(sqlite3_step(query), SQLITE_ROW);
    const std::vector<std::string> cells = RowCells(run.result);
    ASSERT_EQ(static_cast<std::size_t>(sqlite3_column_count(query)), cells.size());
    for (int i = 0; i < sqlite3_column_count(query); ++i) {
      const std::string& cell = cells[static_cast<std::size_t>(i)];
      if (sqlite3_column_type(query, i) == SQLITE_FLOAT) {
        EXPECT_EQ(NumberText(sqlite3_column_double(query, i)), cell);
      } else {
        EXPECT_EQ(reinterpret_cast<const char*>(sqlite3_column_text(query, i)), cell);
      }
    }
  }
  EXPECT_EQ(sqlite3_step(query), SQLITE_DONE);
  sqlite3_finalize(query);
}

TEST(Database, HoldsWhatTheCsvHolds) {
  const TemporaryFolder folder;
  FinishedRuns runs = SomeRuns();
  runs[5].result = SomeRow();
  runs[5].result.lateral_error_m = 0.0;  // SQLite has no negative zero
  WriteDatabase(folder.path() / "results.sqlite", runs);
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open((folder.path() / "results.sqlite").c_str(), &database), SQLITE_OK);
  ExpectTableEquals(database, runs);
  sqlite3_close(database);
}

TEST(Database, IsTheSameFileForTheSameRows) {
  const TemporaryFolder folder;
  WriteDatabase(folder.path() / "a", SomeRuns());
  WriteDatabase(folder.path() / "b", SomeRuns());
  WriteDatabase(folder.path() / "b", SomeRuns());  // over an old one
  EXPECT_EQ(ReadText(folder.path() / "a"), ReadText(folder.path() / "b"));
}

TEST(Database, SaysWhereItCannotBeWritten) {
  try {
    WriteDatabase("/nowhere/results.sqlite", SomeRuns());
    FAIL() << "written to a folder that is not there";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot write /nowhere/results.sqlite: "));
  }
}

TEST(RowAsJson, HoldsWhatTheCsvHolds) {
  const RunResult row = SomeRow();
  const Json json = Json::parse(RowJson(row).dump());
  EXPECT_EQ(json.size(), RowCells(row).size());
  EXPECT_EQ(json["seed"].get<std::uint64_t>(), row.seed);
  EXPECT_EQ(json["docked"], row.docked);
  EXPECT_EQ(json["outcome"], Name(row.outcome));
  EXPECT_EQ(json["tip_depth_m"].get<double>(), row.tip_depth_m);
  EXPECT_EQ(json["state_hash"], "00000000000000af");
  EXPECT_EQ(json.begin().key(), "run");
}

TEST(RowAsJson, HasNullForWhatIsNotANumber) {
  RunResult row = SomeRow();
  row.tip_depth_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(RowJson(row).dump(), HasSubstr("\"tip_depth_m\":null"));
}

TEST(Outcome, EveryNameLeadsBackToItsOutcome) {
  for (int i = 0; i <= static_cast<int>(Outcome::kCrashed); ++i) {
    EXPECT_EQ(OutcomeFromName(Name(static_cast<Outcome>(i))), static_cast<Outcome>(i));
  }
  EXPECT_FALSE(OutcomeFromName("Docked").has_value());
}

}  // namespace
}  // namespace dockyard
