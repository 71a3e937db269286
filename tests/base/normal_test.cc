#include "sim/base/normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dockyard {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Computed by mpmath 1.3 with 60 digits.
TEST(NormalQuantile, IsTheHighPrecisionValueFromTheFarTailToTheMiddle) {
  const struct {
    double p, z;
  } cases[] = {
      {1e-306, -37.417889786351415}, {1e-300, -37.047096299361199}, {1e-200, -30.205594179579643},
      {1e-100, -21.273453560965324}, {1e-50, -14.933337534788489},  {1e-20, -9.2623400897984076},
      {1e-16, -8.2220822161304356},  {1e-10, -6.3613409024040562},  {1e-5, -4.2648907939228246},
      {0.001, -3.0902323061678135},  {0.025, -1.9599639845400542},  {0.07, -1.4757910281791707},
      {0.075, -1.4395314709384559},  {0.08, -1.4050715603096326},   {0.25, -0.67448975019608174},
      {0.4, -0.25334710313579974},   {0.75, 0.67448975019608174},   {0.95, 1.6448536269514723},
      {0.975, 1.9599639845400539},   {0.999, 3.0902323061678133}};
  for (const auto& [p, z] : cases) {
    EXPECT_NEAR(NormalQuantile(p), z, 1e-15 * std::abs(z)) << p;
  }
  EXPECT_EQ(NormalQuantile(0.5), 0.0);
}

TEST(NormalQuantile, IsOddAboutTheMedian) {
  for (const double p : {0x1.0p-53, 0x1.0p-30, 0x1.0p-5, 0.0625, 0.09375, 0.25, 0.4375}) {
    EXPECT_EQ(NormalQuantile(1.0 - p), -NormalQuantile(p)) << p;
  }
}

// Where the three rational functions meet: p = 0.075 and p = exp(-25).
TEST(NormalQuantile, RisesAcrossItsSeams) {
  for (const double seam : {0.075, std::exp(-25.0)}) {
    double last = NormalQuantile(seam * (1.0 - 1e-12));
    for (int i = -9; i <= 9; ++i) {
      const double z = NormalQuantile(seam * (1.0 + 1e-13 * i));
      EXPECT_GT(z, last) << seam << " " << i;
      last = z;
    }
  }
}

// A relative error e of z changes the share by z^2 e or less.
TEST(NormalQuantile, GoesBackToTheShareInBothTails) {
  for (double p = 1e-300; p < 0.5; p *= 7.3) {
    const double z = NormalQuantile(p);
    EXPECT_NEAR(NormalShare(z) / p, 1.0, 1e-15 * (2.0 + z * z)) << p;
    EXPECT_NEAR(NormalShare(-z), 1.0 - p, 2e-16) << p;
  }
}

TEST(NormalQuantileDeathTest, RefusesTheEnds) {
  for (const double p : {0.0, 1.0, std::nan("")}) EXPECT_DEATH(NormalQuantile(p), "check failed");
}

// Computed by mpmath 1.3 with 30 digits.
TEST(NormalShare, IsTheHighPrecisionValue) {
  const struct {
    double z, p, tolerance;
  } cases[] = {{-37.0, 5.7255712225245768e-300, 2e-13}, {-30.0, 4.9067139271481871e-198, 2e-13},
               {-10.0, 7.6198530241605261e-24, 2e-14},  {-5.0, 2.8665157187919391e-7, 5e-15},
               {-1.0, 0.15865525393145705, 1e-15},      {0.0, 0.5, 0.0},
               {0.5, 0.69146246127401310, 1e-15},       {3.0, 0.99865010196836991, 1e-15}};
  for (const auto& [z, p, tolerance] : cases) EXPECT_NEAR(NormalShare(z) / p, 1.0, tolerance) << z;
  EXPECT_EQ(NormalShare(-kInfinity), 0.0);
  EXPECT_EQ(NormalShare(kInfinity), 1.0);
}

}  // namespace
}  // namespace dockyard
