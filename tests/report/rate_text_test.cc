#include "sim/report/rate_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard {
namespace {

TEST(RateText, SaysHowSureItIs) {
  EXPECT_EQ(RateText(31, 40), "31/40 (78 %, 62-89 %)");
  EXPECT_EQ(RateText(29, 40), "29/40 (73 %, 56-85 %)");
  EXPECT_EQ(RateText(0, 0), "0/0");
}

TEST(ChanceText, WritesNoZero) {
  EXPECT_EQ(PText(0.0703125), "p = 0.0703");
  EXPECT_EQ(PText(0.0001), "p = 0.0001");
  EXPECT_EQ(PText(9.9e-5), "p < 0.0001");
  EXPECT_EQ(PText(0.0), "p < 0.0001");
  EXPECT_EQ(ChanceText(1.0), "1.0000");
  EXPECT_EQ(ChanceText(std::nan("")), "nan");
}

TEST(BriefNumber, HasFourFigures) {
  EXPECT_EQ(BriefNumber(0.210349), "0.2103");
  EXPECT_EQ(BriefNumber(-12.0), "-12");
  EXPECT_EQ(BriefNumber(-std::nan("")), "nan");
}

}  // namespace
}  // namespace dockyard
