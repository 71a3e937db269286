#include "sim/draws/sobol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dockyard {
namespace {

double Coordinate(const SobolPoints& points, std::size_t dimension, std::uint64_t point) {
  return std::ldexp(static_cast<double>(points.Digits(dimension, point)), -64);
}

// Point 4, counted from 0, with the direction numbers of Joe and Kuo (2008), as scipy has it too.
TEST(SobolPoints, AreThePublishedOnes) {
  const SobolPoints points(10, 5);
  const double fourth[] = {0.375, 0.375, 0.625, 0.875, 0.375, 0.125, 0.375, 0.875, 0.875, 0.625};
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(Coordinate(points, k, 0), 0.0);
    EXPECT_EQ(Coordinate(points, k, 1), 0.5);
    EXPECT_EQ(Coordinate(points, k, 4), fourth[k]);
  }
}

// By a program in Python from the first lines of new-joe-kuo-6.21201: the first 20 binary digits.
TEST(SobolPoints, FarOutAreThoseOfAnIndependentProgram) {
  const SobolPoints points(10, 1000000);
  const std::uint64_t digits[] = {0x04c71, 0xe5d9f, 0x5df79, 0x09123, 0xdaefd,
                                  0x9d893, 0xc682d, 0x164c9, 0x26e81, 0xcb207};
  for (int k = 0; k < 10; ++k) EXPECT_EQ(points.Digits(k, 999999), digits[k] << 44);
}

TEST(SobolPoints, HitEachIntervalOnceInEveryDimension) {
  constexpr std::uint64_t kPoints = 128;
  const SobolPoints points(kSobolDimensions, kPoints);
  for (std::size_t k = 0; k < kSobolDimensions; ++k) {
    std::vector<int> hits(kPoints);
    for (std::uint64_t i = 0; i < kPoints; ++i) ++hits[points.Digits(k, i) >> 57];
    ASSERT_EQ(std::count(hits.begin(), hits.end(), 1), static_cast<long>(kPoints)) << k;
  }
}

// The first two dimensions are a (0, 2)-sequence in base 2 (Sobol' 1967).
TEST(SobolPoints, HitEachBoxOfEqualAreaOnceInTheFirstTwoDimensions) {
  constexpr int kBits = 10;
  const SobolPoints points(2, 1 << kBits);
  for (int wide = 1; wide < kBits; ++wide) {
    std::vector<int> hits(1 << kBits);
    for (int i = 0; i < 1 << kBits; ++i) {
      const std::uint64_t column = points.Digits(0, i) >> (64 - wide);
      const std::uint64_t row = points.Digits(1, i) >> (64 - (kBits - wide));
      ++hits[(column << (kBits - wide)) + row];
    }
    EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), 1 << kBits) << wide;
  }
}

TEST(SobolPoints, AreTheSameForMorePointsOrDimensions) {
  const SobolPoints few(3, 9), many(40, 100000);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 9; ++i) EXPECT_EQ(few.Digits(k, i), many.Digits(k, i));
  }
}

TEST(SobolPoints, MayBeNone) {
  const SobolPoints no_dimensions(0, 1000), one_point(3, 1);
  EXPECT_EQ(one_point.Digits(2, 0), 0u);
}

TEST(SobolPointsDeathTest, EndWithTheTable) {
  EXPECT_DEATH(SobolPoints(kSobolDimensions + 1, 8), "check failed");
  EXPECT_DEATH(SobolPoints(2, 8).Digits(2, 0), "check failed");
  EXPECT_DEATH(SobolPoints(2, 8).Digits(0, 8), "check failed");
}

}  // namespace
}  // namespace dockyard
