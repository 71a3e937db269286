#include "sim/rocky7/last_touch.h"

#include <gtest/gtest.h>

namespace dockyard::rocky7 {
namespace {

// A hard first touch, a soft one 4 s later, and forces in between that are too short apart to be
// touches of their own.
TEST(LastTouch, IsTheFaceWhenTheLastTouchPressedMost) {
  LastTouch touch;
  const auto add = [&](double time_s, double force_n) {
    Add(time_s, force_n, {time_s, 0.0, 0.0}, {0.0, 0.0, force_n}, touch);
  };
  add(0.0, 0.0);
  EXPECT_EQ(touch.force_n, 0.0);
  for (const double force_n : {1.0, 3.0, 2.0}) add(10.0 + 0.1 * force_n, force_n);
  EXPECT_EQ(touch.force_n, 3.0);
  EXPECT_DOUBLE_EQ(touch.p_GF.x(), 10.3);
  add(10.6, 0.0);
  add(10.65, 1.0);  // springs back
  EXPECT_EQ(touch.force_n, 3.0);
  add(14.0, 0.5);
  add(14.1, 1.5);
  add(14.2, 1.0);
  EXPECT_EQ(touch.force_n, 1.5);
  EXPECT_DOUBLE_EQ(touch.p_GF.x(), 14.1);
  EXPECT_EQ(touch.axis_G.z(), 1.5);
}

}  // namespace
}  // namespace dockyard::rocky7
