// The laws of a patch of soil against their closed forms.
#include "sim/soil/soil_laws.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/soil/envelope.h"
#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

TEST(Pressure, FollowsBekkersPlateCurve) {
  SoilModel soil = Soil("pavlov_90");
  soil.k_phi = 8.0e6;
  // 8e6 * 0.02^1.46, computed apart.
  EXPECT_NEAR(YieldPressure(MakeRimLaws(soil, 0.05), 0.020), 26460.24, 0.1);
}

TEST(Pressure, GrowsWithTheWidthAsFarAsPlatesWereMeasured) {
  const SoilModel soil = Soil("pavlov_90");
  const auto k = [&](double width_m) { return MakeRimLaws(soil, width_m).k; };
  EXPECT_NEAR(k(0.06), soil.k_phi, 1e-6);
  EXPECT_NEAR(k(0.08) / k(0.06), 8.0 / 6.0, 1e-12);
  EXPECT_EQ(k(0.05), k(0.06));
  EXPECT_EQ(k(0.15), k(0.10));
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
  EXPECT_NEAR(ShearStrength(sand, 20e3),
              sand.cohesion_pa + 20e3 * std::tan(Radians(29.0 * 2.0 / 3.0)), 1e-6);
  EXPECT_EQ(ShearStrength(sand, 0.0), 0.0);
}

TEST(Shear, NeedsAWayInProportionToTheContactsDepth) {
  const SoilModel soil = Soil("fjs_1");
  const SoilLaws laws = MakeRimLaws(soil, 0.1);
  EXPECT_NEAR(ShearModulus(laws, soil.shear_depth_m), soil.shear_modulus_m, 1e-12);
  EXPECT_NEAR(ShearModulus(laws, 0.060) / ShearModulus(laws, 0.020), 3.0, 1e-12);
  EXPECT_EQ(ContactDepth(0.060), 0.060);
  EXPECT_EQ(ContactDepth(-0.1), kLeastDepth_m);
}

TEST(Shear, OfADrivingWheelThatTakesSoilAlongIsThatOfSoilOnSoil) {
  SoilLaws sand = MakeRimLaws(Soil("pavlov_90"), 0.05);
  sand.tan_caught = sand.tan_phi - sand.tan_rim;  // no gap is left
  const double by_soil = sand.cohesion_pa + 20e3 * std::tan(Radians(29.0));
  EXPECT_NEAR(ShearStrength(sand, 20e3, 1.0), by_soil, 1e-6);
  EXPECT_EQ(ShearStrength(sand, 20e3, 0.0), ShearStrength(sand, 20e3));
}

TEST(Envelope, GivesFrictionItsArcsCohesionAndOneWedge) {
  // 300 N on compact gravel, a wheel of 0.3 m by 0.15 m half in the soil's reach: tan(38 deg) 300
  // N, 5 kPa over the arc of acos(1 - 0.02/0.3), and 1/2 1963 g 0.02^2 N_phi 0.15 m.
  const SoilLaws granite = MakeRimLaws(Soil("compact_gravel"), 0.15);
  const double arc_m = 0.3 * std::acos(1.0 - 0.02 / 0.3);
  const double wedge_n = 0.5 * 1963.0 * 9.81 * 0.0004 * 4.2037 * 0.15;
  EXPECT_NEAR(EnvelopeStrength(granite, 300.0, 0.3, 0.15, 0.02),
              300.0 * std::tan(Radians(38.0)) + 5000.0 * 0.15 * arc_m + wedge_n, 1e-3);
}

TEST(Envelope, BoundsWhatTheFacesPush) {
  for (const double rim_n : {-40.0, 0.0, 40.0}) {
    for (const double faces_n : {1.0, 50.0, 1e3, 1e6}) {
      const Envelope sum{100.0, rim_n, faces_n};
      const double pushed_n = FaceShare(sum, 90.0) * faces_n;
      EXPECT_LT(rim_n + pushed_n, 90.0);
      EXPECT_NEAR(FaceShare({100.0, -rim_n, -faces_n}, 90.0) * faces_n, pushed_n, 1e-9);
    }
  }
  EXPECT_NEAR(FaceShare({100.0, 40.0, 50.0}, 90.0), 0.5, 1e-12);
  EXPECT_EQ(FaceShare({100.0, 95.0, 50.0}, 90.0), 0.0);  // rim and tips took it all
}

TEST(FacePressure, IsRankinesWithTheHeapOnTheWeightAlone) {
  const SoilLaws granite = MakeRimLaws(Soil("compact_gravel"), 0.15);
  // N_phi = tan^2(64 deg) = 4.2037; 1963 * 9.81 * 0.03 * N_phi, and 2 * 5000 * sqrt(N_phi).
  EXPECT_NEAR(FacePressure(granite, 0.03, 0.0), 2428.5, 0.5);
  EXPECT_NEAR(FacePressure(granite, 0.03, 1.0), kHeap * 2428.5 + 20503.0, 2.0);
}

TEST(BladePressure, ReachesTerzaghisStripStrength) {
  SoilModel soil = Soil("compact_gravel");
  const double depth_m = 0.02;
  // Prandtl and Reissner for 38 deg: N_c = 61.35, N_q = 48.93.
  const double strength = 5000.0 * 61.35 + 1963.0 * 9.81 * depth_m * 48.93;
  soil.k_phi = 1e12;
  EXPECT_NEAR(BladePressure(MakeTipLaws(soil, 0.006, 0.15), depth_m) / strength, 1.0, 1e-3);
  EXPECT_EQ(BladePressure(MakeRimLaws(soil, 0.15), depth_m), 0.0);
}

// So a soil's measured plate curve decides how deep a wheel stands on its paddles' tips.
TEST(BladePressure, BeginsAsAPlatesAtTheSameDepthOverWidth) {
  const SoilModel soil = Soil("compact_gravel");
  const SoilLaws tip = MakeTipLaws(soil, 0.006, 0.15), rim = MakeRimLaws(soil, 0.15);
  EXPECT_NEAR(BladePressure(tip, 1e-9) / YieldPressure(rim, 25e-9), 1.0, 1e-2);
  SoilModel softer = soil;
  softer.k_phi *= 0.5;
  EXPECT_LT(BladePressure(MakeTipLaws(softer, 0.006, 0.15), 0.001),
            0.8 * BladePressure(tip, 0.001));
}

}  // namespace
}  // namespace dockyard::soil_test
