// Noise that is a pure function of a key and a place, so that no order of evaluation matters.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "controller/base/split_mix.h"

namespace dockyard {

/// Uniform in [0, 1).
constexpr double HashUniform(std::uint64_t key, std::uint64_t place) {
  return static_cast<double>(SplitMix(key, place) >> 11) * 0x1.0p-53;
}

/// Standard normal to within an excess kurtosis of -0.03, tails to 8 sigma: the count of ones among
/// 64 fair bits (variance 16), its lattice filled by a uniform (variance 1/12).
inline float HashNormal(std::uint64_t key, std::uint64_t place) {
  const std::uint64_t bits = SplitMix(key, place);
  std::uint64_t n = bits - ((bits >> 1) & 0x5555555555555555ull);
  n = (n & 0x3333333333333333ull) + ((n >> 2) & 0x3333333333333333ull);
  n = (n + (n >> 4)) & 0x0f0f0f0f0f0f0f0full;
  const int ones = static_cast<int>((n * 0x0101010101010101ull) >> 56);
  // Another product of the same bits hardly knows how many of them are set.
  const auto fill = static_cast<std::int32_t>((bits * 0xd1342543de82ef95ull) >> 32);
  constexpr float kScale = 0.24935149f;  // 1 / sqrt(16 + 1/12)
  return kScale * (static_cast<float>(ones - 32) + 0x1.0p-32f * static_cast<float>(fill));
}

/// Three standard normal numbers of one place, for its three colours: as above, of 21 bits each
/// (excess kurtosis -0.1, tails to 4.6 sigma).
struct ThreeNormals {
  float a, b, c;
};
inline ThreeNormals HashNormals(std::uint64_t key, std::uint64_t place) {
  const std::uint64_t bits = SplitMix(key, place);
  const std::uint64_t other = bits * 0xd1342543de82ef95ull;
  const auto normal = [&](int shift) {
    constexpr std::uint32_t kBits = (1u << 21) - 1u;
    std::uint32_t n = static_cast<std::uint32_t>(bits >> shift) & kBits;
    n -= (n >> 1) & 0x55555555u;
    n = (n & 0x33333333u) + ((n >> 2) & 0x33333333u);
    n = (n + (n >> 4)) & 0x0f0f0f0fu;
    const int ones = static_cast<int>((n * 0x01010101u) >> 24);
    const auto fill = static_cast<int>(static_cast<std::uint32_t>(other >> (shift + 1)) & kBits);
    constexpr float kScale = 0.43301270f;  // 1 / sqrt(21/4 + 1/12)
    return kScale * (static_cast<float>(ones - 11) + 0x1.0p-21f * static_cast<float>(fill));
  };
  return {normal(0), normal(21), normal(42)};
}

/// Poisson numbers of means up to 400.
inline float DrawPoisson(float mean, std::uint64_t key, std::size_t place) {
  const double u = HashUniform(key ^ 0x6a09e667f3bcc909ull, place);
  double term = std::exp(-static_cast<double>(mean)), sum = term;
  int n = 0;
  while (u > sum && n < 400) {
    term *= mean / ++n;
    sum += term;
  }
  return static_cast<float>(n);
}

}  // namespace dockyard
