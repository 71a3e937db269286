// Random numbers from one counter-based generator, so that each stream of each run can be drawn by
// itself and a further stream shifts no other. The draws are our own arithmetic, the same on every
// standard library.
#pragma once

#include <cstdint>
#include <string_view>

namespace dockyard {

/// The sequence of SplitMix64 whose seed is the key.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t key) : key_(key) {}

  std::uint64_t NextBits();
  /// Uniform in [0, 1), 53 bits.
  double Uniform();
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  /// Standard normal by the inverse of its distribution function: one word of bits each.
  double Normal();

 private:
  std::uint64_t key_ = 0;
  std::uint64_t counter_ = 0;
};

/// Uniform in the open interval (0, 1) from a word of random bits: the middle of one of 2^52 equal
/// cells, so at least 2^-53 from either end.
double OpenUnit(std::uint64_t bits);

/// Key of one named stream of one run's seed.
std::uint64_t StreamKey(std::uint64_t seed, std::string_view stream);
/// Seed of all that the runs at one place of a campaign share. A place is a point of the campaign's
/// grid or a row of its table, counted from 0.
std::uint64_t PlaceSeed(std::uint64_t campaign_seed, std::uint64_t place);
/// Seed of one run's world: the run at that place with `repeat` others before it. Place and repeat
/// are mixed one after the other, so that more places or more repeats shift no seed.
std::uint64_t WorldSeed(std::uint64_t campaign_seed, std::uint64_t place, std::uint64_t repeat);

}  // namespace dockyard
