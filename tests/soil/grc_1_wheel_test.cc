// Grousered wheels on GRC-1 simulant, against the one published number that is known: a wheel of
// 23 cm pulls 0.11 +- 0.02 of its load at slip 0.2, in lunar gravity (IEEE Aerospace 2012, through
// a secondary source). The source states neither load nor width nor grousers, so these are assumed
// over a range: on the Moon a rover of 50 kg on four such wheels loads each with 20 N.
#include <gtest/gtest.h>

#include <cstdio>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

constexpr double kLow = 0.09, kHigh = 0.13;  // 0.11 +- 0.02

/// Drawbar over load at slip 0.2 with the soil as on the Moon.
double Pull(double load_n) {
  SingleWheelSetup setup;
  setup.wheel.rim_radius_m = 0.115;
  setup.wheel.width_m = 0.115;             // assumed, range 0.06-0.15
  setup.wheel.paddle_count = 16;           // assumed, range 12-24
  setup.wheel.paddle_height_m = 0.012;     // assumed, range 0.008-0.018
  setup.wheel.paddle_thickness_m = 0.002;  // assumed, range 0.001-0.004
  setup.soil = Soil("grc_1");
  setup.soil.gravity_m_s2 = 1.62;
  setup.load_n = load_n;
  setup.slip = 0.2;
  const double pull = RunSingleWheel(setup).ahead_n / load_n;
  std::printf("%.0f N: drawbar %.3f of the load\n", load_n, pull);
  return pull;
}

TEST(Grc1, PullsAsPublishedUnderAMiddlingLoad) {
  // Small loads sink less and pull more; the range of 12-40 N is assumed.
  EXPECT_GT(Pull(12.0), kLow);
  const double middling = Pull(20.0);
  EXPECT_GT(middling, kLow);
  EXPECT_LT(middling, kHigh);
  EXPECT_LT(Pull(40.0), kHigh);
}

}  // namespace
}  // namespace dockyard::soil_test
