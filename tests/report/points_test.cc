#include "sim/report/points.h"

#include <gmock/gmock.h>

#include <cmath>

#include "sim/report/plot_labels.h"
#include "sim/statistics/intervals.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const std::vector<std::string> kSettings{"start.alpha_deg", "changed", "changed_to"};
const std::vector<std::string> kMeasures{"success", "force_peak_n"};

RowColumns Columns() {
  RowColumns columns = FakeColumns();
  columns.labels = kSettings;
  return columns;
}

Spread Of(const std::string& measure, const Rows& rows) {
  return SpreadOf(Columns(), measure, rows);
}

/// A row at that angle; `to`: what changes.a was set to alone, if it was.
RunResult Row(int run, const std::string& alpha, bool docked, double force_n,
              const std::string& to = "") {
  RunResult row;
  row.run = run;
  row.seed = 7;
  row.labels = {alpha, to.empty() ? "" : "changes.a", to};
  row.success = docked;
  row.outcome = docked ? "docked" : "missed";
  row.sim_time_s = 30.0;
  row.measures = {0.2, force_n, 0.0};
  return row;
}

TEST(Points, SumUpWhatTheSystemStatesBesideSuccessAndTime) {
  std::vector<std::string> names;
  for (const Column& column : SummedColumns(Columns())) names.push_back(column.name);
  EXPECT_THAT(names,
              ElementsAre("success", "sim_time_s", "depth_m", "force_peak_n", "yaw_error_deg"));
  RunResult row = Row(1, "0", true, 3.0);
  row.sim_time_s = 12.5;
  EXPECT_EQ(Of("success", {&row}).mean, 1.0);
  EXPECT_EQ(Of("sim_time_s", {&row}).mean, 12.5);
  EXPECT_EQ(Of("depth_m", {&row}).mean, 0.2);
}

TEST(Points, ShareHasTheExactIntervalAndOthersTheirQuantiles) {
  std::vector<RunResult> rows;
  for (int i = 0; i < 11; ++i) rows.push_back(Row(i + 1, "0", i < 8, 10.0 * i));
  Rows all;
  for (const RunResult& row : rows) all.push_back(&row);
  const Spread share = Of("success", all);
  EXPECT_DOUBLE_EQ(share.mean, 8.0 / 11.0);
  EXPECT_EQ(share.low, ClopperPearson(8, 11).low);
  EXPECT_EQ(share.high, ClopperPearson(8, 11).high);
  const Spread force = Of("force_peak_n", all);
  EXPECT_DOUBLE_EQ(force.median, 50.0);
  EXPECT_DOUBLE_EQ(force.low, 10.0);
  EXPECT_DOUBLE_EQ(force.high, 90.0);
}

TEST(Points, NotANumberCountsInNoSpread) {
  const RunResult outside = Row(1, "0", false, std::nan("")), inside = Row(2, "0", true, 0.4);
  const Spread spread = Of("force_peak_n", {&outside, &inside});
  EXPECT_EQ(spread.count, 1);
  EXPECT_DOUBLE_EQ(spread.mean, 0.4);
  EXPECT_EQ(Of("success", {&outside, &inside}).count, 2);
}

TEST(Points, ACrashedRunCountsAsNotDockedAndInNoOtherSpread) {
  RunResult crashed = Row(1, "0", false, 0.0);
  crashed.measures.clear();
  const RunResult good = Row(2, "0", true, 100.0);
  const Spread spread = Of("force_peak_n", {&crashed, &good});
  EXPECT_EQ(spread.count, 1);
  EXPECT_EQ(spread.mean, 100.0);
  EXPECT_EQ(Of("success", {&crashed, &good}).mean, 0.5);
  EXPECT_EQ(Of("sim_time_s", {&crashed, &good}).count, 1);
}

TEST(Points, TablesSayWhatWasSetAndWhatCameOut) {
  const std::vector<RunResult> rows{Row(1, "0", true, 80.0), Row(2, "0", false, 120.0),
                                    Row(5, "5", true, 90.0, "1")};
  const std::string points = PointsCsv(kSettings, Columns(), rows);
  EXPECT_THAT(points, HasSubstr("start.alpha_deg,changed,changed_to,runs,success,success_low,"
                                "success_high,docked,docked_low,"));
  EXPECT_THAT(points, HasSubstr("\n0,,,2,0.5,"));
  EXPECT_THAT(points, HasSubstr("\n5,changes.a,1,1,1,"));
  const std::string table = PointsTable(kSettings, kMeasures, Columns(), rows);
  EXPECT_THAT(table, HasSubstr("| 0 |  |  | 1/2 (50 %, 1-99 %) | 100 (84 to 116) |"));
}

TEST(Points, CurvesBandIsInTheirPlotAndChangedPointsStayOut) {
  const Figures figures{.x = "start.alpha_deg", .curves = "", .panels = "", .measures = kMeasures};
  std::vector<RunResult> rows;
  for (const char* alpha : {"0", "5", "10"}) rows.push_back(Row(1, alpha, true, 50.0));
  const std::string before = CurvesPlot("sample", figures, Columns(), rows);
  EXPECT_THAT(before, HasSubstr("<polygon"));
  rows.push_back(Row(9, "5", false, 500.0, "2"));
  // But for the number of runs in the title.
  EXPECT_EQ(CurvesPlot("sample", figures, Columns(), rows).size(), before.size());
  EXPECT_EQ(CurvesPlot("sample", {.x = "", .curves = "", .panels = "", .measures = kMeasures},
                       Columns(), rows),
            "");
}

TEST(Points, CurvesByControllerNeedNoLabel) {
  const Figures figures{
      .x = "start.alpha_deg", .curves = "controller", .panels = "", .measures = {"success"}};
  std::vector<RunResult> rows{Row(1, "0", true, 1.0), Row(2, "0", true, 1.0)};
  rows[0].controller = "old";
  rows[1].controller = "new";
  const std::string plot = CurvesPlot("sample", figures, Columns(), rows);
  EXPECT_THAT(plot, HasSubstr(">old<"));
  EXPECT_THAT(plot, HasSubstr(">new<"));
}

TEST(Points, BarsAreTheDifferenceFromTheUnchanged) {
  const std::vector<RunResult> rows{Row(1, "0", true, 80.0), Row(2, "0", false, 120.0, "1")};
  const std::string bars = BarsPlot("sample", kMeasures, Columns(), rows);
  EXPECT_THAT(bars, HasSubstr("changes.a = 1"));
  EXPECT_THAT(bars, HasSubstr("docked 1/1"));
  EXPECT_THAT(bars, HasSubstr("mean force peak [N] 80"));
  EXPECT_THAT(bars, HasSubstr("change of the mean force peak [N]"));
  EXPECT_THAT(BarsPlot("sample", {"success"}, Columns(), rows), Not(HasSubstr("force")));
  EXPECT_EQ(BarsPlot("sample", kMeasures, Columns(), {rows[0]}), "");
  EXPECT_EQ(BarsPlot("sample", kMeasures, FakeColumns(), {}), "");
}

TEST(Points, AxesHaveTheColumnsUnits) {
  EXPECT_EQ(AxisLabel({"force_peak_n", "N", ""}), "force peak [N]");
  EXPECT_EQ(AxisLabel({"depth_m", "m", ""}), "depth [m]");
  EXPECT_EQ(AxisLabel({"speed_m_s", "m/s", ""}), "speed [m/s]");
  EXPECT_EQ(AxisLabel({"recoveries", "", ""}), "recoveries");
  EXPECT_EQ(AxisLabel({"success", "", ""}), "share of successes");
}

}  // namespace
}  // namespace dockyard
