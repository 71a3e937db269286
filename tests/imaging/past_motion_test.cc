#include "controller/imaging/past_motion.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

TEST(PastMotion, GivesTheMomentNearestToATime) {
  PastMotion past(1000);
  for (Tick t = 0; t <= 500; t += 50) past.Add({.tick = t, .X_OR = {1e-3 * double(t), 0, 0}});
  EXPECT_EQ(past.Nearest(200).tick, 200);
  EXPECT_DOUBLE_EQ(past.Nearest(200).X_OR.x, 0.2);
  EXPECT_EQ(past.Nearest(220).tick, 200);
  EXPECT_EQ(past.Nearest(230).tick, 250);
  EXPECT_EQ(past.Nearest(-900).tick, 0);
  EXPECT_EQ(past.Nearest(900).tick, 500);
}

TEST(PastMotion, ForgetsWhatIsOlderThanItKeeps) {
  PastMotion past(100);
  EXPECT_FALSE(past.Holds(0));
  for (Tick t = 0; t <= 500; t += 50) past.Add({.tick = t});
  EXPECT_FALSE(past.Holds(399));
  EXPECT_TRUE(past.Holds(400));
  EXPECT_TRUE(past.Holds(477));
  EXPECT_TRUE(past.Holds(501));  // by a camera whose clock is ahead
  EXPECT_TRUE(past.Holds(550));
  EXPECT_FALSE(past.Holds(551));
  EXPECT_EQ(past.Nearest(520).tick, 500);
  EXPECT_EQ(past.Nearest(0).tick, 400);
  past.Clear();
  EXPECT_FALSE(past.Holds(450));
}

}  // namespace
}  // namespace dockyard
