#include "sim/draws/permutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "controller/base/split_mix.h"
#include "draws/goodness.h"

namespace dockyard {
namespace {

// Sizes on both sides of the change of method, full tables and ones with spare cells.
TEST(Permuted, HitsEveryIndexOnce) {
  for (const std::uint64_t size : {1, 2, 3, 7, 10, 63, 64, 65, 66, 81, 100, 1000, 4097, 100003}) {
    for (const std::uint64_t key : {0ull, 1ull, ~0ull}) {
      std::vector<int> hits(size);
      for (std::uint64_t i = 0; i < size; ++i) {
        const std::uint64_t place = Permuted(i, size, key);
        ASSERT_LT(place, size);
        ++hits[place];
      }
      EXPECT_EQ(std::count(hits.begin(), hits.end(), 1), static_cast<long>(size)) << size;
    }
  }
}

TEST(Permuted, MakesAllPermutationsOfAFewElementsEquallyOften) {
  for (const auto& [size, permutations] : {std::pair{2, 2}, {3, 6}, {4, 24}, {5, 120}}) {
    std::vector<int> counts(permutations);
    for (int key = 0; key < 60000; ++key) {
      std::vector<std::uint64_t> order;
      for (int i = 0; i < size; ++i) order.push_back(Permuted(i, size, SplitMix(99, key)));
      int number = 0;  // Lehmer's code
      for (int i = 0; i < size; ++i) {
        const auto smaller = [&](std::uint64_t later) { return later < order[i]; };
        number = number * (size - i) +
                 static_cast<int>(std::count_if(order.begin() + i + 1, order.end(), smaller));
      }
      ++counts[number];
    }
    // Wilson and Hilferty is no good at one degree of freedom: the quantile is 10.83.
    const double bound = size == 2 ? 10.83 : ChiSquareBound(permutations - 1);
    EXPECT_LT(ChiSquare(counts), bound) << size;
  }
}

// Neighbours in a row of the table, in a column, and far from each other.
TEST(Permuted, SendsTwoIndicesToEachPairOfPlacesEquallyOften) {
  for (const auto& [size, first, second] :
       {std::tuple{12, 0, 1}, {64, 0, 63}, {65, 0, 1}, {65, 0, 9}, {65, 3, 60}, {81, 0, 2}}) {
    std::vector<int> counts(size * size);
    constexpr int kKeys = 100000;
    for (int key = 0; key < kKeys; ++key) {
      const std::uint64_t mixed = SplitMix(7, key);
      ++counts[Permuted(first, size, mixed) * size + Permuted(second, size, mixed)];
    }
    std::vector<int> possible;
    for (int i = 0; i < size * size; ++i) {
      if (i / size != i % size) possible.push_back(counts[i]);
    }
    EXPECT_LT(ChiSquare(possible), ChiSquareBound(size * (size - 1.0) - 1.0))
        << size << ": " << first << ", " << second;
  }
}

// The indices of one long permutation: i and i + 1, and i and i + the width of the table.
TEST(Permuted, ScattersNeighboursUniformly) {
  constexpr std::uint64_t kSize = 100000, kWidth = 317;
  PairCounts next(16), below(16);
  const auto place = [](std::uint64_t i) {
    return static_cast<double>(Permuted(i, kSize, 31)) / kSize;
  };
  for (std::uint64_t i = 0; i + kWidth < kSize; ++i) {
    const double here = place(i);
    next.Add(here, place(i + 1));
    below.Add(here, place(i + kWidth));
  }
  EXPECT_LT(next.ChiSquare(), ChiSquareBound(255));
  EXPECT_LT(below.ChiSquare(), ChiSquareBound(255));
}

// Literals of a program in Python that shares nothing with the source: a change of the arithmetic
// must not go unseen.
TEST(Permuted, IsThatOfAnIndependentProgram) {
  const std::uint64_t ten[] = {4, 1, 5, 8, 7, 0, 9, 3, 2, 6};
  for (int i = 0; i < 10; ++i) EXPECT_EQ(Permuted(i, 10, 5), ten[i]);
  const std::uint64_t thousand[] = {846, 701, 267, 482, 115, 484};
  for (int i = 0; i < 6; ++i) EXPECT_EQ(Permuted(i, 1000, 5), thousand[i]);
  const std::uint64_t million[] = {460307, 856780, 994064, 861943};
  for (int i = 0; i < 4; ++i) EXPECT_EQ(Permuted(i, 1000000, 5), million[i]);
}

TEST(PermutedDeathTest, RefusesAnIndexBeyondTheEnd) {
  EXPECT_DEATH(Permuted(10, 10, 1), "check failed");
  EXPECT_DEATH(Permuted(0, kLongestPermutation + 1, 1), "check failed");
}

}  // namespace
}  // namespace dockyard
