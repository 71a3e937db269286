#include "controller/axel/options_for.h"

#include <gtest/gtest.h>

namespace dockyard::axel {
namespace {

TEST(OptionsFor, TheDefaultRoverAreThoseOfTheHeader) {
  const AxelOptions fitted = OptionsFor({}), header;
  EXPECT_EQ(fitted.tether.drive_tension_n, header.tether.drive_tension_n);
  EXPECT_EQ(fitted.mate.lean_limit_rad, header.mate.lean_limit_rad);
  EXPECT_EQ(fitted.plan.lift_share, header.plan.lift_share);
  EXPECT_EQ(fitted.noise.weight_n, header.noise.weight_n);
}

// The margin of the station's hold has nothing to do with the rover's weight.
TEST(OptionsFor, ForcesGoWithTheWeightAndSharesOfItStay) {
  Nominal nominal;
  nominal.rover_mass_kg *= 1.5;
  nominal.gravity_m_s2 = 3.71;
  nominal.arm_down_nm *= 1.5 * 3.71 / 9.81;
  const double factor = 1.5 * 3.71 / 9.81;
  const AxelOptions fitted = OptionsFor(nominal), header;
  for (const auto& [here_n, there_n] :
       {std::pair(fitted.tether.drive_tension_n, header.tether.drive_tension_n),
        std::pair(fitted.tether.search_tension_n, header.tether.search_tension_n),
        std::pair(fitted.mate.taut_tension_n, header.mate.taut_tension_n),
        std::pair(fitted.noise.weight_n, header.noise.weight_n)}) {
    EXPECT_NEAR(here_n, factor * there_n, 1e-9);
  }
  EXPECT_NEAR(fitted.plan.lift_share, header.plan.lift_share, 1e-12);
  EXPECT_EQ(fitted.hold.over_n, header.hold.over_n);
}

TEST(OptionsFor, AnArmInAWiderSocketMayLeanMoreByThatMuch) {
  Nominal nominal;
  nominal.seated_play_rad += 0.01;
  const AxelOptions fitted = OptionsFor(nominal), header;
  EXPECT_NEAR(fitted.mate.lean_limit_rad, header.mate.lean_limit_rad + 0.01, 1e-12);
}

TEST(OptionsFor, ALighterArmIsLiftedByLessThrust) {
  Nominal nominal;
  nominal.arm_down_nm *= 0.5;
  EXPECT_NEAR(OptionsFor(nominal).plan.lift_share, 0.5 * AxelOptions{}.plan.lift_share, 1e-12);
}

}  // namespace
}  // namespace dockyard::axel
