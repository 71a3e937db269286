#include "controller/rocky7/tipping.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

constexpr MastAngles kUp{0.0, -0.5 * kPi, 0.0};  // both links straight up

// 10 kg in the middle between axles that are 0.478 m apart, 0.13 m over the ground; the limbs weigh
// nothing.
Nominal WithoutLimbs() {
  Nominal nominal = NominalRover();
  nominal.masses = {.rover_kg = 10.0, .p_RC = {0.17, 0.0, 0.06}};
  return nominal;
}

ImuSample Tilted(double roll_rad, double pitch_rad) {
  ImuSample attitude;
  attitude.roll_rad = roll_rad;
  attitude.pitch_rad = pitch_rad;
  return attitude;
}

TEST(TippingMargin, OnASlopeIsLessByTheHeightTimesItsTangent) {
  const Nominal nominal = WithoutLimbs();
  const double height_m = 0.06 + nominal.rolling_radius_m;
  EXPECT_NEAR(TippingMargin(nominal, {}, {0.0, 0.0}, kUp), 0.2, 1e-12);
  for (const double slope_rad : {0.1, 0.3}) {
    const double less_m = height_m * std::tan(slope_rad);
    EXPECT_NEAR(TippingMargin(nominal, Tilted(slope_rad, 0.0), {0.0, 0.0}, kUp), 0.2 - less_m,
                1e-12);
    EXPECT_NEAR(TippingMargin(nominal, Tilted(0.0, slope_rad), {0.0, 0.0}, kUp),
                std::min(0.2, 0.409 - 0.17 - less_m), 1e-12);
  }
  // It tips over its side where the slope's tangent is 0.2 / 0.13.
  EXPECT_LT(TippingMargin(nominal, Tilted(std::atan(0.21 / height_m), 0.0), {0.0, 0.0}, kUp), 0.0);
}

// Level: the lever law, with 1 kg at the end of the arm, 0.68 m ahead, or 2 kg in the middle
// of a mast's second link, which is stretched to the left by 0.5 and 0.25 m.
TEST(TippingMargin, WithALimbOutFollowsTheLeverLaw) {
  Nominal nominal = WithoutLimbs();
  nominal.masses.arm_kg = 1.0;
  nominal.masses.arm_middle_m = nominal.arm.length_m;
  const double x_m = (10.0 * 0.17 + 0.68) / 11.0;
  EXPECT_NEAR(TippingMargin(nominal, {}, {0.0, 0.0}, kUp), 0.409 - x_m, 1e-12);
  nominal = WithoutLimbs();
  nominal.masses.link2_kg = 2.0;
  nominal.masses.link2_middle_m = 0.25;
  const double y_m = 2.0 * 0.75 / 12.0;
  EXPECT_NEAR(TippingMargin(nominal, {}, {0.0, 0.0}, {0.5 * kPi, 0.0, 0.0}), 0.2 - y_m, 1e-12);
}

}  // namespace
}  // namespace dockyard::rocky7
