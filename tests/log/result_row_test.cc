#include "sim/log/result_row.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/base/text.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RunResult SomeRow() {
  RunResult row = FakeRecord(FakeRuns(5)[4]).result;
  row.seed = 0xfedcba9876543210ull;  // beyond 2^63
  row.state_hash = 0x00000000000000afull;
  row.measures = {-0.0, 0.1 + 0.2, 5e-324};
  row.labels = {"in, \"quotes\"", "2.5"};
  return row;
}

RunResult CrashedRow() {
  RunResult row = SomeRow();
  row.success = false;
  row.outcome = kCrashed;
  row.measures.clear();
  return row;
}

std::vector<std::string> ColumnsThatDiffer(const RunResult& a, const RunResult& b,
                                           const RowColumns& columns) {
  std::vector<std::string> names;
  for (const DifferingCell& cell : DifferingCells(a, b, columns)) names.push_back(cell.column);
  return names;
}

TEST(ResultRow, HasTheHeadThenLabelsThenOutcomeThenMeasuresByName) {
  EXPECT_EQ(CsvHeader(FakeColumns()),
            "run,seed,system,controller,soil,start.r_m,success,success_word,docked,outcome,sim_"
            "time_s,images,depth_m,"
            "force_peak_n,yaw_error_deg,state_hash");
}

TEST(ResultRow, ReadsBackToTheSameBits) {
  const RowColumns columns = FakeColumns();
  const RunResult row = SomeRow();
  const auto back = RowFromCsv(CsvRow(row, columns), columns);
  ASSERT_TRUE(back.has_value());
  EXPECT_THAT(ColumnsThatDiffer(row, *back, columns), IsEmpty());
  EXPECT_EQ(back->labels, row.labels);
  EXPECT_TRUE(std::signbit(back->measures[0]));
  EXPECT_EQ(back->measures[1], 0.1 + 0.2);
  EXPECT_EQ(back->measures[2], 5e-324);
  EXPECT_EQ(back->seed, row.seed);
}

TEST(ResultRow, OfACrashedRunHasEmptyMeasuresAndReadsBackToNone) {
  const RowColumns columns = FakeColumns();
  const std::string line = CsvRow(CrashedRow(), columns);
  EXPECT_THAT(line, EndsWith(",14,,,,00000000000000af"));
  const auto back = RowFromCsv(line, columns);
  ASSERT_TRUE(back.has_value());
  EXPECT_THAT(back->measures, IsEmpty());
  EXPECT_EQ(CsvRow(*back, columns), line);
}

TEST(ResultRow, WithoutLabelsAndMeasuresIsItsHeadAlone) {
  RowColumns columns = FakeColumns();
  columns.labels.clear();
  columns.measures.clear();
  RunResult row = SomeRow();
  row.labels.clear();
  row.measures.clear();
  const auto back = RowFromCsv(CsvRow(row, columns), columns);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(CsvHeader(columns),
            "run,seed,system,controller,success,success_word,docked,outcome,sim_time_s,images,"
            "state_hash");
  EXPECT_THAT(ColumnsThatDiffer(row, *back, columns), IsEmpty());
}

TEST(ResultRow, TellsWhichColumnsDiffer) {
  const RunResult row = SomeRow();
  RunResult other = row;
  other.state_hash ^= 1;
  other.labels[1] = "2.50";
  other.measures[1] = std::nextafter(row.measures[1], 1.0);
  EXPECT_THAT(ColumnsThatDiffer(row, other, FakeColumns()),
              ElementsAre("start.r_m", "force_peak_n", "state_hash"));
  EXPECT_THAT(
      ColumnsThatDiffer(row, CrashedRow(), FakeColumns()),
      ElementsAre("success", "docked", "outcome", "depth_m", "force_peak_n", "yaw_error_deg"));
  const DifferingCell cell = DifferingCells(row, other, FakeColumns()).front();
  EXPECT_EQ(cell.was, "2.5");
  EXPECT_EQ(cell.is, "2.50");
}

TEST(ResultRow, RefusesALineThatIsNotOneWholeRow) {
  const RowColumns columns = FakeColumns();
  const std::string line = CsvRow(SomeRow(), columns);
  ASSERT_TRUE(RowFromCsv(line, columns).has_value());
  for (std::size_t length = 0; length < line.size(); ++length) {
    EXPECT_FALSE(RowFromCsv(line.substr(0, length), columns).has_value()) << length;
  }
  EXPECT_FALSE(RowFromCsv(line + ",1", columns).has_value());
}

/// With a measure and two limits' margins.
RowColumns ColumnsWithMargins() {
  RowColumns columns = FakeColumns();
  columns.measures = WithMargins({columns.measures[0]},
                                 {{"depth_m", "m", "of the point", LimitSense::kAtLeast, 0.0, 0.0},
                                  {"force_n", "N", "of it"}});
  return columns;
}

TEST(ResultRow, OfAnEarlierProgramHasNoWordAndNoMarginsButAllElse) {
  const RowColumns columns = ColumnsWithMargins(), former = FormerColumns(columns);
  EXPECT_EQ(CsvHeader(former),
            "run,seed,system,controller,soil,start.r_m,docked,outcome,sim_time_s,images,depth_m,"
            "state_hash");
  const auto row =
      RowFromCsv("7,9,fake,straight,loose,2.5,1,docked,99.5,14,0.25,00000000000000af", former);
  ASSERT_TRUE(row.has_value());
  EXPECT_TRUE(row->success);
  EXPECT_EQ(row->success_word, "");
  EXPECT_EQ(row->measures[0], 0.25);
  ASSERT_EQ(row->measures.size(), 3u);
  EXPECT_TRUE(std::isnan(row->measures[1]) && std::isnan(row->measures[2]));
  // A run of today that came to the same is the same.
  RunResult now = *row;
  now.former = false;
  now.success_word = "docked";
  now.measures = {0.25, 0.05, 3.0};
  EXPECT_THAT(ColumnsThatDiffer(*row, now, columns), IsEmpty());
  now.measures[0] = 0.26;
  EXPECT_THAT(ColumnsThatDiffer(*row, now, columns), ElementsAre("depth_m"));
}

TEST(ResultRow, OfAnEarlierProgramThatWasLostIsRead) {
  const RowColumns former = FormerColumns(ColumnsWithMargins());
  const auto lost =
      RowFromCsv("7,9,fake,straight,loose,2.5,0,crashed,0,0,,0000000000000000", former);
  ASSERT_TRUE(lost.has_value());
  EXPECT_TRUE(lost->measures.empty());
}

/// The row of one successful run with one cell changed.
bool IsRead(std::size_t cell, const std::string& text) {
  const RowColumns columns = FakeColumns();
  std::vector<std::string> cells = RowCells(SomeRow(), columns);
  cells.at(cell) = text;
  return RowFromCsv(CsvLine(cells), columns).has_value();
}

TEST(ResultRow, RefusesADamagedCell) {
  ASSERT_TRUE(IsRead(0, "5"));
  EXPECT_FALSE(IsRead(0, "five"));
  EXPECT_FALSE(IsRead(1, "18446744073709551616"));  // 2^64
  EXPECT_FALSE(IsRead(6, "true"));
  EXPECT_FALSE(IsRead(6, "0"));           // docked says 1
  EXPECT_FALSE(IsRead(8, "0"));           // success says 1
  EXPECT_FALSE(IsRead(9, "drove_past"));  // none of this system's
  EXPECT_FALSE(IsRead(9, "missed"));      // no success
  EXPECT_FALSE(IsRead(10, ""));
  EXPECT_FALSE(IsRead(13, ""));  // one measure alone
  EXPECT_FALSE(IsRead(13, "0.3 N"));
  EXPECT_FALSE(IsRead(15, "af"));
}

TEST(ResultRow, OfARunThatDidNotCrashHasItsMeasures) {
  const RowColumns columns = FakeColumns();
  std::vector<std::string> cells = RowCells(SomeRow(), columns);
  cells[12] = cells[13] = cells[14] = "";
  EXPECT_FALSE(RowFromCsv(CsvLine(cells), columns).has_value());
}

TEST(ResultRow, GivesALabelThatIsAlreadyAColumnANameOfItsOwn) {
  RowColumns columns = FakeColumns();
  columns.labels = {"controller", "depth_m", "Seed", "failure_note", "table.controller"};
  EXPECT_EQ(CsvHeader(columns),
            "run,seed,system,controller,table.controller,table.depth_m,table.Seed,"
            "table.failure_note,table.table.controller,success,success_word,docked,outcome,sim_"
            "time_s,images,depth_m,"
            "force_peak_n,yaw_error_deg,state_hash");
}

TEST(RowAsJson, HoldsWhatTheCsvHoldsByName) {
  const RowColumns columns = FakeColumns();
  const RunResult row = SomeRow();
  const Json json = Json::parse(RowJson(row, columns).dump());
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  EXPECT_EQ(names, ColumnNames(columns));
  EXPECT_EQ(json["seed"].get<std::uint64_t>(), row.seed);
  EXPECT_EQ(json["success"], true);
  EXPECT_EQ(json["docked"], true);  // the former name
  EXPECT_EQ(json["outcome"], "docked");
  EXPECT_EQ(json["soil"], "in, \"quotes\"");
  EXPECT_EQ(json["start.r_m"], "2.5");  // text, as the table has it
  EXPECT_EQ(json["force_peak_n"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["state_hash"], "00000000000000af");
}

TEST(RowAsJson, HasNullForWhatIsNotANumberAndForWhatIsMissing) {
  RunResult row = SomeRow();
  row.measures[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(RowJson(row, FakeColumns()).dump(),
              HasSubstr("\"depth_m\":null,\"force_peak_n\":0.3"));
  const Json crashed = RowJson(CrashedRow(), FakeColumns());
  EXPECT_TRUE(crashed["depth_m"].is_null());
  EXPECT_TRUE(crashed["yaw_error_deg"].is_null());
}

}  // namespace
}  // namespace dockyard
