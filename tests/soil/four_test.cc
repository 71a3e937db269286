// Four numbers at once against one after the other, and powers against the C library's.
#include "sim/soil/four.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/random.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/patch.h"
#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

TEST(Power, IsWithinItsStatedErrorOfTheCLibrarys) {
  double worst = 0.0;
  for (double exponent : {0.3, 0.8, 1.0, 1.1, 1.46, 2.5}) {
    for (double base = 1e-30; base < 1e30; base *= 1.00371) {
      const double exact = std::pow(base, exponent);
      worst = std::max(worst, std::fabs(Power(base, exponent) / exact - 1.0));
    }
  }
  EXPECT_LT(worst, 2e-12);
  EXPECT_GT(worst, 1e-16);
}

TEST(Power, GrowsAcrossTheEndsOfItsPolynomials) {
  // Where a mantissa passes sqrt(1/2), the exponent goes on by one.
  for (int i = -40; i < 10; ++i) {
    const double at = std::ldexp(std::sqrt(0.5), i);
    for (double exponent : {0.5, 1.1}) {
      EXPECT_LT(Power(at * (1.0 - 1e-11), exponent), Power(at * (1.0 + 1e-11), exponent));
    }
  }
}

TEST(Four, GivesEachOfFourTheBitsOfOne) {
  RandomStream random(3);
  const auto four = [&](double low, double high) {
    const auto one = [&] { return random.Uniform(low, high); };
    const double a = one(), b = one(), c = one(), d = one();
    return Four(a, b, c, d);
  };
  for (int k = 0; k < 200; ++k) {
    const Four a = four(-2.0, 2.0), b = four(-2.0, 2.0), c = four(1e-6, 1.0);
    const Four result = Select(a < b, Max(a, -b) / c, Min(Abs(a), b) - Sqrt(c) * Power(c, 1.3));
    for (int i = 0; i < 4; ++i) {
      const double one = a[i] < b[i] ? Max(a[i], -b[i]) / c[i]
                                     : Min(Abs(a[i]), b[i]) - Sqrt(c[i]) * Power(c[i], 1.3);
      EXPECT_EQ(result[i], one);
    }
    EXPECT_EQ(Largest(a), std::max({a[0], a[1], a[2], a[3]}));
    EXPECT_EQ(Any(a > b), a[0] > b[0] || a[1] > b[1] || a[2] > b[2] || a[3] > b[3]);
  }
}

TEST(GroundUnder, ReadsBothFieldsAsTheGridGivesThemAlsoOutside) {
  HeightGrid grid = LevelGrid(-0.5, 1.0, 1.0, 0.1);
  AddUndulation(grid, 0.02, 0.5, 0.0, 3);
  grid.undisturbed_m = grid.heights_m;
  for (double& height : grid.heights_m) height = 0.3 - 2.0 * height;
  const GroundUnder ground(grid);
  const Four x(-0.9, -0.21, 0.5, 0.123), y(0.33, -0.5, 0.5, 7.0);
  Four surface, undisturbed;
  ground.Read(x, y, surface, undisturbed);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(surface[i], grid.Height(x[i], y[i]), 1e-12);
    EXPECT_NEAR(surface[i], 0.3 - 2.0 * undisturbed[i], 1e-12);
    double one_surface = 0.0, one_undisturbed = 0.0;
    ground.Read(x[i], y[i], one_surface, one_undisturbed);
    EXPECT_EQ(one_surface, surface[i]);
    EXPECT_EQ(one_undisturbed, undisturbed[i]);
  }
}

/// A wheel's spokes on their way through sand: in and out of it, slipping, and back.
TEST(LoadPatch, GivesFourPatchesTheBitsOfOneAfterTheOther) {
  HeightGrid grid = LevelGrid(-1.0, 2.0, 2.0, 0.02);
  AddUndulation(grid, 0.01, 0.5, 0.0, 3);
  grid.undisturbed_m = grid.heights_m;
  const GroundUnder ground(grid);
  const SoilLaws laws = MakeRimLaws(Soil("pavlov_90"), 0.15);
  const WheelTravel travel{{0.9, 0.1}, 0.2, 1e-3};
  PatchOf<Four> four;
  std::array<Patch, 4> ones;
  int loaded = 0;
  for (int step = 0; step < 4000; ++step) {
    WheelMotion motion;
    const double t = 1e-3 * step;
    motion.X_GK.p = Eigen::Vector3d(0.05 * t, 0.0, 0.29 + 0.02 * std::cos(9.0 * t));
    motion.X_GK.R = RotZ(0.1) * RotY(0.4 * std::sin(t));
    motion.v_GK_G = Eigen::Vector3d(0.05, 0.01, -0.18 * std::sin(9.0 * t));
    motion.w_GK_G = motion.X_GK.R * Eigen::Vector3d(0.02, 0.4 * std::cos(t), 0.0);
    const WheelFrame frame(motion, 1e-3);
    const Four angle(1.2, 1.4, 1.6, 1.8);
    Four cos, sin;
    cos = {std::cos(angle[0]), std::cos(angle[1]), std::cos(angle[2]), std::cos(angle[3])};
    sin = {std::sin(angle[0]), std::sin(angle[1]), std::sin(angle[2]), std::sin(angle[3])};
    const PatchPlaceOf<Four> at(ground, frame, frame.Along(cos, sin), 0.3, 0.05, 0.29);
    const SpokeLoadOf<Four> load = LoadPatch(laws, travel, 0.02, at, 1e-3, 1e-3, four);
    for (int i = 0; i < 4; ++i) {
      const PatchPlace one(ground, frame, frame.Along(cos[i], sin[i]), 0.3, 0.05, 0.29);
      const SpokeLoad alone = LoadPatch(laws, travel, 0.02, one, 1e-3, 1e-3, ones[i]);
      ASSERT_EQ(load.r[i], alone.r);
      ASSERT_EQ(load.t[i], alone.t);
      ASSERT_EQ(load.a[i], alone.a);
      ASSERT_EQ(four.floor_m[i], ones[i].floor_m);
      ASSERT_EQ(four.into[i], ones[i].into);
      loaded += alone.r < 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(loaded, 2000);
  EXPECT_LT(loaded, 14000);
}

}  // namespace
}  // namespace dockyard::soil_test
