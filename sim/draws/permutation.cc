#include "sim/draws/permutation.h"

#include <array>
#include <cmath>

#include "controller/base/check.h"
#include "controller/base/split_mix.h"

namespace dockyard {
namespace {

// Pairs of indices look random from eight rounds on, in a chi-square test with 10^6 keys; with six
// they do not.
constexpr std::uint64_t kRounds = 10;
// Below it a network mixes badly: it reaches only half of the permutations of a 3 x 3 table.
constexpr std::uint64_t kShortest = 65;

/// Number `place` of the key's sequence, scaled to be below `limit`, which is at most 2^32.
std::uint64_t ValueBelow(std::uint64_t limit, std::uint64_t key, std::uint64_t place) {
  return ((SplitMix(key, place) >> 32) * limit) >> 32;
}

std::uint64_t SumBelow(std::uint64_t limit, std::uint64_t a, std::uint64_t b) {
  const std::uint64_t sum = a + b;
  return sum < limit ? sum : sum - limit;
}

/// The whole shuffle of Fisher and Yates, for the sake of one element.
std::uint64_t Shuffled(std::uint64_t index, std::uint64_t size, std::uint64_t key) {
  std::array<std::uint8_t, kShortest - 1> order;
  for (std::uint64_t i = 0; i < size; ++i) {
    const std::uint64_t other = ValueBelow(i + 1, key, i);
    order[i] = order[other];
    order[other] = static_cast<std::uint8_t>(i);
  }
  return order[index];
}

// A Feistel network on the rows and columns of a nearly square table with `size` cells or a few
// more (Black and Rogaway, Ciphers with arbitrary finite domains, CT-RSA 2002): each round shifts
// one of the two by a value that the other chooses, and can be undone. A result among the spare
// cells goes through again until it falls below `size`: that walks along a cycle of the larger
// permutation, so no two indices meet.
std::uint64_t Networked(std::uint64_t index, std::uint64_t size, std::uint64_t key) {
  const auto columns = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(size))));
  const std::uint64_t rows = (size + columns - 1) / columns;
  do {
    std::uint64_t row = index / columns, column = index % columns;
    for (std::uint64_t round = 0; round < kRounds; round += 2) {
      column = SumBelow(columns, column, ValueBelow(columns, key, row * kRounds + round));
      row = SumBelow(rows, row, ValueBelow(rows, key, column * kRounds + round + 1));
    }
    index = row * columns + column;
  } while (index >= size);
  return index;
}

}  // namespace

std::uint64_t Permuted(std::uint64_t index, std::uint64_t size, std::uint64_t key) {
  DOCKYARD_CHECK(index < size && size <= kLongestPermutation);
  return size < kShortest ? Shuffled(index, size, key) : Networked(index, size, key);
}

}  // namespace dockyard
