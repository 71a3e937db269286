#include "sim/report/margins.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fake_runs.h"

namespace dockyard {
namespace {

RunResult Judged(int run, bool success, std::vector<double> measures) {
  RunResult row;
  row.run = run;
  row.success = success;
  row.outcome = success ? "docked" : "missed";
  row.measures = std::move(measures);
  return row;
}

TEST(Margins, CountsBrokenLimitsAndFindsTheLeastMarginOfTheSuccesses) {
  RowColumns columns = FakeColumns();
  columns.measures = WithMargins({{"images", "", ""}}, {{"force_n", "N", "on the cone"},
                                                        {"depth_m", "m", "of the tip"},
                                                        {"turn_deg", "deg", "never judged"}});
  const double none = std::nan("");
  const std::vector<RunResult> rows{
      Judged(1, true, {0.0, 100.0, 0.005, none}), Judged(2, true, {0.0, 60.0, 0.003, none}),
      Judged(3, false, {0.0, 5.0, -0.1, none}), Judged(4, false, {0.0, none, -0.2, none}),
      Judged(5, false, {})};
  const std::vector<LimitOverRuns> limits = LimitsOverRuns(columns, rows);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].name, "depth_m");  // broken most often
  EXPECT_EQ(limits[0].judged, 4);
  EXPECT_EQ(limits[0].broken, 2);
  EXPECT_EQ(limits[0].least->run, 2);
  EXPECT_EQ(limits[0].least_margin, 0.003);
  EXPECT_EQ(limits[1].name, "force_n");
  EXPECT_EQ(limits[1].judged, 3);
  EXPECT_EQ(limits[1].broken, 0);
  EXPECT_EQ(limits[1].least_margin, 60.0);
}

TEST(Margins, OfLimitsThatNoRunBrokeTheOneNearestToItIsFirst) {
  RowColumns columns = FakeColumns();
  columns.measures = WithMargins({}, {{"force_n", "N", ""}, {"depth_m", "m", ""}});
  const std::vector<RunResult> rows{Judged(1, true, {100.0, 0.005}), Judged(2, true, {90.0, 0.005}),
                                    Judged(3, true, {110.0, 0.001})};
  EXPECT_EQ(LimitsOverRuns(columns, rows)[0].name, "depth_m");
}

}  // namespace
}  // namespace dockyard
