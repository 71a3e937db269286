#include "sim/base/count_text.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace dockyard
