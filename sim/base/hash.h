// FNV-1a over the bits of doubles: the fingerprint of a run.
#pragma once

#include <bit>
#include <cstdint>

namespace dockyard {

inline constexpr std::uint64_t kHashSeed = 14695981039346656037ull;

inline std::uint64_t HashBits(std::uint64_t hash, std::uint64_t bits) {
  for (int byte = 0; byte < 8; ++byte) {
    hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 1099511628211ull;
  }
  return hash;
}
inline std::uint64_t HashDouble(std::uint64_t hash, double value) {
  return HashBits(hash, std::bit_cast<std::uint64_t>(value));
}

}  // namespace dockyard
