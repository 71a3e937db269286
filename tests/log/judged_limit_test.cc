#include "sim/log/judged_limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

const JudgedLimit kDepth{"seat_depth_m",       "m",   "tip behind the mouth",
                         LimitSense::kAtLeast, 0.189, 0.225};
const JudgedLimit kForce{"force_n", "N", "on the cone", LimitSense::kAtMost, 900.0, 1000.0};
const JudgedLimit kTurn{"shake_turn_deg",    "deg",        "under the shake",
                        LimitSense::kAtMost, std::nan(""), 4.4};

TEST(JudgedLimit, MarginIsPositiveOnTheGoodSideOfEitherSense) {
  EXPECT_NEAR(kDepth.margin(), -0.036, 1e-12);
  EXPECT_EQ(kForce.margin(), 100.0);
  EXPECT_TRUE(std::isnan(kTurn.margin()));
}

TEST(JudgedLimit, BrokenOnesAreSaidWithValueAndLimit) {
  EXPECT_EQ(BrokenLimitsText({kDepth, kForce, kTurn}), "seat depth 189 mm (at least 225 mm)");
  JudgedLimit heavy = kForce;
  heavy.value = 1000.5;
  EXPECT_EQ(BrokenLimitsText({kDepth, heavy}),
            "seat depth 189 mm (at least 225 mm), force 1000.5 N (at most 1000 N)");
  EXPECT_EQ(BrokenLimitsText({kForce, kTurn}), "");
}

TEST(JudgedLimit, TightestHasTheLeastShareOfItsLimit) {
  EXPECT_EQ(TightestLimit({kForce, kDepth, kTurn})->name, "seat_depth_m");  // -16 % against 10 %
  EXPECT_EQ(TightestLimit({kTurn}), nullptr);
}

TEST(JudgedLimit, ColumnsFollowTheMeasuresAndTheJsonHasTheJudgedOnes) {
  const auto columns = WithMargins({{"images", "", ""}}, {kDepth, kTurn});
  ASSERT_EQ(columns.size(), 3u);
  EXPECT_FALSE(IsMargin(columns[0]));
  EXPECT_TRUE(IsMargin(columns[1]));
  EXPECT_EQ(columns[2].name, "margin.shake_turn_deg");
  EXPECT_EQ(columns[2].unit, "deg");
  const Json json = LimitsJson({kTurn, kForce});
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["name"], "force_n");
  EXPECT_EQ(json[0]["sense"], "at most");
  EXPECT_EQ(json[0]["margin"], 100.0);
}

}  // namespace
}  // namespace dockyard
