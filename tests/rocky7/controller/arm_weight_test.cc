#include "controller/rocky7/arm_weight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

// An arm of 0.8 kg rises, with or without a stone at its end, through the span in two seconds.
RisingCurrent Rise(double stone_kg, double noise_a, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  RisingCurrent rise;
  for (double pitch_rad = 0.3; pitch_rad > -0.3; pitch_rad -= 0.01) {
    const double moment_nm = (0.8 * 0.17 + stone_kg * 0.32) * 9.81 * std::cos(pitch_rad);
    const double current_a = 0.1 + (moment_nm + 0.2) / 3.0 + noise_a * noise(random);
    rise.Add(pitch_rad, std::abs(current_a));
  }
  return rise;
}

Load Weighed(double stone_kg, double noise_a, unsigned seed) {
  const Nominal nominal = NominalRover();
  return LoadOf(Rise(0.0, noise_a, seed), Rise(stone_kg, noise_a, seed + 1), nominal.arm,
                nominal.motors[9]);
}

TEST(ArmWeight, TellsAStoneOfThreeCentimetresFromNone) {
  int stones = 0, none = 0;
  for (unsigned seed = 0; seed < 200; seed += 2) {
    const Load with = Weighed(0.022, 0.01, seed), without = Weighed(0.0, 0.01, seed);
    EXPECT_NE(with, Load::kNone) << seed;
    EXPECT_NE(without, Load::kStone) << seed;
    stones += with == Load::kStone;
    none += without == Load::kNone;
  }
  EXPECT_GE(stones, 95);
  EXPECT_GE(none, 95);
}

TEST(ArmWeight, DoesNotKnowInTenTimesTheNoise) {
  int known = 0;
  for (unsigned seed = 0; seed < 200; seed += 2) {
    known += Weighed(0.022, 0.1, seed) != Load::kUnknown;
  }
  EXPECT_EQ(known, 0);
}

TEST(ArmWeight, DoesNotBelieveASensorThatReadsNothing) {
  const Nominal nominal = NominalRover();
  RisingCurrent nothing;
  for (int i = 0; i < 60; ++i) nothing.Add(0.0, 0.0);
  EXPECT_EQ(LoadOf(nothing, nothing, nominal.arm, nominal.motors[9]), Load::kUnknown);
  EXPECT_EQ(LoadOf({}, {}, nominal.arm, nominal.motors[9]), Load::kUnknown);
}

}  // namespace
}  // namespace dockyard::rocky7
