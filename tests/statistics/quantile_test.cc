#include "sim/statistics/quantile.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

// R: quantile(x <- c(1, 2, 4, 8, 16), c(0, .1, .25, .5, .9, 1), type = 7)
TEST(SampleQuantile, IsDefinitionSevenOfHyndmanAndFan) {
  const std::vector<double> x{1, 2, 4, 8, 16};
  EXPECT_DOUBLE_EQ(SampleQuantile(x, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(SampleQuantile(x, 0.1), 1.4);
  EXPECT_DOUBLE_EQ(SampleQuantile(x, 0.25), 2.0);
  EXPECT_DOUBLE_EQ(SampleQuantile(x, 0.5), 4.0);
  EXPECT_DOUBLE_EQ(SampleQuantile(x, 0.9), 12.8);
  EXPECT_DOUBLE_EQ(SampleQuantile(x, 1.0), 16.0);
}

TEST(SampleQuantile, OfOneValueIsThatValue) {
  for (const double share : {0.0, 0.3, 1.0}) EXPECT_EQ(SampleQuantile({7.5}, share), 7.5);
}

}  // namespace
}  // namespace dockyard
