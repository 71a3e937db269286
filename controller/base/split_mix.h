// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): random bits as a pure function of key and place,
// so that no order of evaluation matters. Seeds, noise of images and textures come from it.
#pragma once

#include <cstdint>

namespace dockyard {

/// Its finaliser: every bit of z changes half of the result's bits.
constexpr std::uint64_t MixBits(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// The value at place 0, 1, 2 ... of the sequence with that seed.
constexpr std::uint64_t SplitMix(std::uint64_t seed, std::uint64_t place) {
  return MixBits(seed + 0x9e3779b97f4a7c15ull * (place + 1));
}

}  // namespace dockyard
