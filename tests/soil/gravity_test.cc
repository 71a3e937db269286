// Soil in another gravity. Slonaker et al. (2017): a wheel of the same size in sand without
// cohesion rolls alike when gravity and load fall by the same factor. Kobayashi et al. (2010) saw
// the same sinkage in flight.
#include <gtest/gtest.h>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

constexpr double kShare = 1.0 / 6.0;  // the Moon's gravity

SingleWheelResult Roll(const char* wheel, double slip, double share) {
  SingleWheelSetup setup;
  setup.wheel = Wheel(wheel);
  setup.soil = Soil("pavlov_90");
  setup.soil.cohesion_pa = 0.0;
  setup.soil.gravity_m_s2 *= share;
  setup.load_n = 24.0 * share;
  setup.slip = slip;
  return RunSingleWheel(setup);
}

TEST(Gravity, OfASixthWithASixthOfTheLoadRollsAsOnEarth) {
  for (const char* wheel : {"pavlov_grouser", "pavlov_smooth"}) {
    for (const double slip : {0.0, 0.2, 0.5}) {
      const SingleWheelResult here = Roll(wheel, slip, 1.0), there = Roll(wheel, slip, kShare);
      const double load_n = 24.0;
      EXPECT_NEAR(there.ahead_n / kShare / load_n, here.ahead_n / load_n, 1e-3) << wheel << slip;
      EXPECT_NEAR(there.torque_nm / kShare, here.torque_nm, 2e-3) << wheel << slip;
      EXPECT_NEAR(there.sinkage_m, here.sinkage_m, 5e-5) << wheel << slip;
    }
  }
}

// The soil's weight alone is not enough: k_phi carries the wheel, and was measured on Earth.
TEST(Gravity, AlsoLightensWhatCarriesTheWheel) {
  SingleWheelSetup setup;
  setup.wheel = Wheel("pavlov_smooth");
  setup.soil = Soil("pavlov_90");
  setup.load_n = 24.0;
  const double here_m = RunSingleWheel(setup).sinkage_m;
  setup.soil.gravity_m_s2 *= kShare;
  EXPECT_GT(RunSingleWheel(setup).sinkage_m, 1.5 * here_m);
}

}  // namespace
}  // namespace dockyard::soil_test
