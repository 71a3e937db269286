#include "sim/page/curves_part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/page/overview_part.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

Campaign Design() {
  Campaign campaign;
  campaign.grid.resize(1);
  campaign.grid[0].key.name = "start.r_m";
  campaign.figures.measures = {"success"};
  return campaign;
}

// Two runs at each of nine ranges. With n of n successes the exact 95 % interval begins at
// 0.025^(1/n), with none of n it ends at 1 - 0.025^(1/n).
TEST(CurvesPart, HasTheShareAndItsExactIntervalAtEachValue) {
  const FinishedRuns runs = FakeResults(18);
  const Json curves = CurvesPart(Design(), runs, FakeColumns());
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0]["x"], "start.r_m");
  EXPECT_EQ(curves[0]["measure"], "success");
  const Json& points = curves[0]["curves"][0]["points"];
  ASSERT_EQ(points.size(), 9u);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(points[i]["x"], 2.0 + 0.5 * static_cast<double>(i));
    EXPECT_EQ(points[i]["runs"], 2);
    const bool docked = i % 3 != 0;  // runs i and i + 9: every third fails
    EXPECT_EQ(points[i]["value"], docked ? 1.0 : 0.0);
    const double end = std::sqrt(0.025);
    EXPECT_NEAR(points[i]["low"].get<double>(), docked ? end : 0.0, 1e-9);
    EXPECT_NEAR(points[i]["high"].get<double>(), docked ? 1.0 : 1.0 - end, 1e-9);
  }
}

TEST(CurvesPart, DrawsWhatTheFiguresAskFor) {
  Campaign campaign = Design();
  campaign.figures = {.x = "start.r_m", .curves = "soil", .measures = {"success", "depth_m"}};
  const Json curves = CurvesPart(campaign, FakeResults(36), FakeColumns());
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[1]["measure"], "depth_m");
  EXPECT_EQ(curves[1]["unit"], "m");
  for (const Json& figure : curves) {
    EXPECT_EQ(figure["by"], "soil");
    ASSERT_EQ(figure["curves"].size(), 2u);
    EXPECT_EQ(figure["curves"][0]["name"], "compact");
    EXPECT_EQ(figure["curves"][1]["name"], "loose");
  }
}

TEST(CurvesPart, WordsAreNoAxis) {
  Campaign campaign = Design();
  campaign.grid[0].key.name = "soil";
  EXPECT_TRUE(CurvesPart(campaign, FakeResults(12), FakeColumns()).empty());
}

TEST(OverviewPart, HasTheLimitsOfRequirementsOnSuccess) {
  Requirement on_success, on_depth;
  on_success.text = "success >= 0.9";
  on_success.figure = "success";
  on_success.limit = 0.9;
  on_depth.text = "depth_m.p90 <= 5";
  on_depth.figure = "depth_m";
  on_depth.statistic = Requirement::Statistic::kQuantile;
  on_depth.level = 0.9;
  on_depth.relation = Requirement::Relation::kAtMost;
  on_depth.limit = 5.0;
  const Campaign campaign = Design();
  const Json json = OverviewPart(&campaign, FakeResults(18), FakeColumns(),
                                 AcceptanceAim{0.8, 0.95}, {on_success, on_depth});
  ASSERT_EQ(json["aims"].size(), 2u);
  EXPECT_EQ(json["aims"][0]["share"], 0.8);
  EXPECT_EQ(json["aims"][1]["share"], 0.9);
  ASSERT_EQ(json["requirements"].size(), 2u);
  EXPECT_EQ(json["requirements"][0]["met"], false);  // 12 of 18
  EXPECT_EQ(json["requirements"][1]["met"], true);   // three sigma are 1 m
}

}  // namespace
}  // namespace dockyard
