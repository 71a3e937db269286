#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "models/read/config_error.h"
#include "sim/statistics/intervals.h"
#include "sim/study/plot_labels.h"
#include "sim/study/run_study.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

YamlNode Number(const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.scalar = text;
  return node;
}

/// Three values of a number; one key changed alone, to two values.
Study Sample() {
  Study study;
  study.name = "sample";
  study.repeats = 4;
  study.factors = {{"start.alpha_deg", {"0", "5", "10"}, {Number("0"), Number("5"), Number("10")}}};
  study.one_at_a_time = {{"changes.a", {"1", "2"}, {Number("1"), Number("2")}}};
  study.x = "start.alpha_deg";
  study.measures = {"docked", "force_peak_n"};
  for (int change = 0; change < 3; ++change) {
    for (int level = 0; level < 3; ++level) {
      StudyPoint point;
      point.level = {level};
      point.changed = change == 0 ? -1 : 0;
      point.changed_level = change - 1;
      study.points.push_back(point);
    }
  }
  return study;
}

RowColumns Columns() {
  RowColumns columns = FakeColumns();
  columns.labels.clear();
  return columns;
}

Spread Of(const std::string& measure, const std::vector<const StudyRow*>& rows) {
  return SpreadOf(StudyColumns(Columns()), measure, rows);
}

StudyRow Row(int run, int point, bool docked, double force_n) {
  return {
      run, point, 7, docked ? "docked" : "missed", {docked ? 1.0 : 0.0, 30.0, 0.2, force_n, 0.0}};
}

TEST(Study, MeasuresWhatTheSystemStatesBesideSuccessAndTime) {
  std::vector<std::string> names;
  for (const Column& column : StudyColumns(Columns())) names.push_back(column.name);
  EXPECT_THAT(names,
              ElementsAre("docked", "sim_time_s", "depth_m", "force_peak_n", "yaw_error_deg"));
  RunResult row;
  row.docked = true;
  row.sim_time_s = 12.5;
  row.measures = {0.25, 3.0, -1.0};
  EXPECT_THAT(MeasuresOf(row), ElementsAre(1.0, 12.5, 0.25, 3.0, -1.0));
}

TEST(Study, RefusesToPlotWhatIsNotMeasured) {
  Study study = Sample();
  CheckMeasures(study, Columns());
  study.measures.push_back("force_peek_n");
  try {
    CheckMeasures(study, Columns());
    FAIL() << "an unknown measure was taken";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(
        error.what(),
        "study sample: plot.measures: expected a column of runs.csv, found 'force_peek_n'; "
        "nearest is 'force_peak_n'");
  }
}

TEST(Study, AKeyChangedAloneMeetsTheSeedsOfTheGrid) {
  const Study study = Sample();
  std::set<std::uint64_t> seeds;
  for (int place = 0; place < 3; ++place) {
    for (int repeat = 0; repeat < 4; ++repeat) {
      const std::uint64_t seed = StudySeed(study, place, repeat);
      seeds.insert(seed);
      EXPECT_EQ(StudySeed(study, place + 3, repeat), seed);
      EXPECT_EQ(StudySeed(study, place + 6, repeat), seed);
    }
  }
  EXPECT_EQ(seeds.size(), 12u);
}

TEST(Study, ShareHasTheExactIntervalAndOthersTheirQuantiles) {
  std::vector<StudyRow> rows;
  for (int i = 0; i < 11; ++i) rows.push_back(Row(i + 1, 0, i < 8, 10.0 * i));
  std::vector<const StudyRow*> all;
  for (const StudyRow& row : rows) all.push_back(&row);
  const Spread share = Of("docked", all);
  EXPECT_DOUBLE_EQ(share.mean, 8.0 / 11.0);
  EXPECT_EQ(share.low, ClopperPearson(8, 11).low);
  EXPECT_EQ(share.high, ClopperPearson(8, 11).high);
  const Spread force = Of("force_peak_n", all);
  EXPECT_DOUBLE_EQ(force.median, 50.0);
  EXPECT_DOUBLE_EQ(force.low, 10.0);
  EXPECT_DOUBLE_EQ(force.high, 90.0);
}

TEST(Study, NotANumberCountsInNoSpread) {
  StudyRow outside = Row(1, 0, false, std::nan("")), inside = Row(2, 0, true, 0.4);
  const Spread spread = Of("force_peak_n", {&outside, &inside});
  EXPECT_EQ(spread.count, 1);
  EXPECT_DOUBLE_EQ(spread.mean, 0.4);
  EXPECT_EQ(Of("docked", {&outside, &inside}).count, 2);
}

TEST(Study, RunsWithoutMeasuresCountInNoSpread) {
  StudyRow crashed = Row(1, 0, false, 0.0);
  crashed.measures.clear();
  const StudyRow good = Row(2, 0, true, 100.0);
  const Spread spread = Of("force_peak_n", {&crashed, &good});
  EXPECT_EQ(spread.count, 1);
  EXPECT_EQ(spread.mean, 100.0);
}

TEST(Study, TablesSayWhatWasSetAndWhatCameOut) {
  const Study study = Sample();
  const std::vector<StudyRow> rows{Row(1, 0, true, 80.0), Row(2, 0, false, 120.0),
                                   Row(5, 4, true, 90.0)};
  const std::string runs = StudyRunsCsv(study, Columns(), rows);
  EXPECT_THAT(
      runs,
      HasSubstr("run,seed,start.alpha_deg,changed,changed_to,outcome,docked,sim_time_s,depth_m,"
                "force_peak_n,yaw_error_deg\n"));
  EXPECT_THAT(runs, HasSubstr("\n1,7,0,,,docked,1,30,0.2,80,0\n"));
  EXPECT_THAT(runs, HasSubstr("\n5,7,5,changes.a,1,docked,1,"));
  const std::string points = StudyPointsCsv(study, Columns(), rows);
  EXPECT_THAT(points, HasSubstr("\n0,,,2,0.5,"));
  const std::string table = StudyTable(study, Columns(), rows);
  EXPECT_THAT(table, HasSubstr("| 0 |  |  | 1/2 (50 %, 1-99 %) | 100 (84 to 116) |"));
}

TEST(Study, CurvesBandIsInTheirPlotAndChangedPointsStayOut) {
  const Study study = Sample();
  std::vector<StudyRow> rows;
  for (int level = 0; level < 3; ++level) rows.push_back(Row(level + 1, level, true, 50.0));
  const std::string before = StudyCurves(study, Columns(), rows);
  EXPECT_THAT(before, HasSubstr("<polygon"));
  rows.push_back(Row(9, 4, false, 500.0));
  // But for the number of runs in the title.
  EXPECT_EQ(StudyCurves(study, Columns(), rows).size(), before.size());
  Study without_x = study;
  without_x.x.clear();
  EXPECT_EQ(StudyCurves(without_x, Columns(), rows), "");
}

TEST(Study, BarsAreTheDifferenceFromTheUnchanged) {
  Study study = Sample();
  const std::vector<StudyRow> rows{Row(1, 0, true, 80.0), Row(2, 3, false, 120.0)};
  const std::string bars = StudyBars(study, Columns(), rows);
  EXPECT_THAT(bars, HasSubstr("changes.a = 1"));
  EXPECT_THAT(bars, Not(HasSubstr("changes.a = 2")));  // no run of it yet
  EXPECT_THAT(bars, HasSubstr("docked 1/1"));
  EXPECT_THAT(bars, HasSubstr("mean force peak [N] 80"));
  EXPECT_THAT(bars, HasSubstr("change of the mean force peak [N]"));
  study.measures = {"docked"};
  EXPECT_THAT(StudyBars(study, Columns(), rows), Not(HasSubstr("force")));
  study.one_at_a_time.clear();
  EXPECT_EQ(StudyBars(study, Columns(), {}), "");
}

TEST(Study, AxesHaveTheColumnsUnits) {
  EXPECT_EQ(AxisLabel({"force_peak_n", "N", ""}), "force peak [N]");
  EXPECT_EQ(AxisLabel({"depth_m", "m", ""}), "depth [m]");
  EXPECT_EQ(AxisLabel({"speed_m_s", "m/s", ""}), "speed [m/s]");
  EXPECT_EQ(AxisLabel({"recoveries", "", ""}), "recoveries");
  EXPECT_EQ(AxisLabel({"docked", "", ""}), "docked share");
}

}  // namespace
}  // namespace dockyard
