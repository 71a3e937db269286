// The laws of a patch of soil against their closed forms.
#include "sim/soil/soil_laws.h"

#include <gtest/gtest.h>

#include <cmath>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

TEST(Pressure, FollowsBekkersPlateCurve) {
  const SoilLaws sand = MakeRimLaws(Soil("pavlov_90"), 0.05);
  // 8e6 * 0.02^1.46, computed apart.
  EXPECT_NEAR(YieldPressure(sand, 0.020), 26460.24, 0.1);
}

TEST(Pressure, CountsThePlatesWidthThroughKc) {
  SoilModel soil = Soil("wong_dry_sand");
  const SoilLaws narrow = MakeRimLaws(soil, 0.05);
  EXPECT_NEAR(narrow.k, 0.99e3 / 0.05 + 1528.43e3, 1e-6);
}

TEST(Bearing, IsWholeStraightInAndLeastAlongTheSurface) {
  const SoilLaws sand = MakeRimLaws(Soil("pavlov_90"), 0.05);
  EXPECT_EQ(BearingShare(sand, 1.0, 0.0), 1.0);
  EXPECT_EQ(BearingShare(sand, 1.0, 1.0), 1.0);
  EXPECT_NEAR(BearingShare(sand, 0.0, 0.0), kDraggedShare, 1e-12);
  EXPECT_NEAR(BearingShare(sand, 0.0, 1.0), kDrivingShare, 1e-12);
  // A patch that lifts bears as one that slides.
  EXPECT_EQ(BearingShare(sand, -1.0, 0.5), BearingShare(sand, 0.0, 0.5));
  EXPECT_NEAR(BearingShare(sand, std::sqrt(0.5), 0.0), 0.5 + 0.5 * kDraggedShare, 1e-12);
}

TEST(Bearing, DoesNotWeakenInSoilThatSlidingLeavesAsItIs) {
  SoilModel soil = Soil("pavlov_90");
  soil.slip_weakening = 0.0;
  const SoilLaws laws = MakeRimLaws(soil, 0.05);
  for (double into : {-1.0, 0.0, 0.3, 1.0}) EXPECT_EQ(BearingShare(laws, into, 0.2), 1.0);
}

TEST(Shear, FollowsJanosisCurveUnderSteadySliding) {
  const double K = 0.021;
  Mobilisation m;
  for (int step = 1; step <= 600; ++step) {
    m = Shear(m, 0.8e-4, 0.6e-4, K);  // 0.1 mm a step along (0.8, 0.6)
    const double janosi = 1.0 - std::exp(-step * 1e-4 / K);
    ASSERT_NEAR(std::hypot(m.t, m.a), janosi, 1e-5);
  }
  EXPECT_NEAR(m.t / m.a, 0.8 / 0.6, 1e-9);
}

TEST(Shear, StaysAtRest) {
  const Mobilisation m{0.3, -0.2};
  EXPECT_EQ(Shear(m, 0.0, 0.0, 0.02), m);
}

TEST(Shear, UnloadsOnReversalBeforeItReverses) {
  const double K = 0.02;
  double m = 0.0;
  for (int step = 0; step < 1000; ++step) m = Shear(m, 1e-4, K);
  ASSERT_GT(m, 0.99);
  // dm = -(1 + m) dj / K back from 1: zero after K ln 2.
  double back_m = 0.0;
  while (m > 0.0) {
    m = Shear(m, -1e-5, K);
    back_m += 1e-5;
  }
  EXPECT_NEAR(back_m, K * std::log(2.0), 2e-4);
}

TEST(Shear, NeverExceedsTheStrength) {
  Mobilisation m;
  for (double slide : {1e-6, 1e-3, 0.1, 10.0, 1e6}) {
    m = Shear(m, slide, -slide, 0.02);
    EXPECT_LE(std::hypot(m.t, m.a), 1.0);
  }
}

TEST(Shear, StrengthIsMohrCoulombAndVanishesWithThePressure) {
  const SoilLaws sand = MakeRimLaws(Soil("pavlov_90"), 0.05);
  // A wheel's metal holds the soil at two thirds of its own friction angle.
  EXPECT_NEAR(ShearStrength(sand, 20e3), 450.0 + 20e3 * std::tan(Radians(29.0 * 2.0 / 3.0)), 1e-6);
  EXPECT_EQ(ShearStrength(sand, 0.0), 0.0);
}

TEST(FacePressure, IsRankinesWithTheHeapOnTheWeightAlone) {
  const SoilLaws granite = MakeRimLaws(Soil("compact_gravel"), 0.15);
  // N_phi = tan^2(64 deg) = 4.2037; 1963 * 9.81 * 0.03 * N_phi, and 2 * 5000 * sqrt(N_phi).
  EXPECT_NEAR(FacePressure(granite, 0.03, 0.0), 2428.5, 0.5);
  EXPECT_NEAR(FacePressure(granite, 0.03, 1.0), kHeap * 2428.5 + 20503.0, 2.0);
}

TEST(BladePressure, ReachesTerzaghisStripStrength) {
  const SoilLaws tip = MakeTipLaws(Soil("compact_gravel"), 0.006, 0.15);
  // Prandtl and Reissner for 38 deg: N_c = 61.35, N_q = 48.93.
  const double depth_m = 0.02;
  const double strength = 5000.0 * 61.35 + 1963.0 * 9.81 * depth_m * 48.93;
  EXPECT_NEAR(BladePressure(tip, depth_m), strength * depth_m / (depth_m + 0.0015), 300.0);
  EXPECT_EQ(BladePressure(MakeRimLaws(Soil("compact_gravel"), 0.15), depth_m), 0.0);
}

}  // namespace
}  // namespace dockyard::soil_test
