#include "sim/base/count_text.h"

#include <gtest/gtest.h>

#include "controller/base/number_text.h"

namespace dockyard {
namespace {

TEST(CountText, HasThePluralOfAllCountsButOne) {
  EXPECT_EQ(CountText(0, "run"), "0 runs");
  EXPECT_EQ(CountText(1, "run"), "1 run");
  EXPECT_EQ(CountText(2u, "run"), "2 runs");
  EXPECT_EQ(CountText(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(CountText(3, "vertex", "vertices"), "3 vertices");
  EXPECT_EQ(CountText(1, "run has", "runs have"), "1 run has");
}

TEST(Fixed, WritesNoSignOnAZero) {
  EXPECT_EQ(Fixed(-0.04, 1), "0.0");
  EXPECT_EQ(Fixed(-0.0, 0), "0");
  EXPECT_EQ(Fixed(-0.06, 1), "-0.1");
  EXPECT_EQ(Fixed(-10.0, 2), "-10.00");
}

}  // namespace
}  // namespace dockyard
