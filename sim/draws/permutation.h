// The order in which a Latin hypercube takes its strata: a permutation without a table.
#pragma once

#include <cstdint>

namespace dockyard {

inline constexpr std::uint64_t kLongestPermutation = std::uint64_t{1} << 32;

/// The place of `index` (below `size`) in a permutation of 0 .. size - 1, size at most
/// kLongestPermutation. Each key has a permutation of its own, as good as a random one.
std::uint64_t Permuted(std::uint64_t index, std::uint64_t size, std::uint64_t key);

}  // namespace dockyard
