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
  /// Standard normal by Box and Muller (1958).
  double Normal();

 private:
  std::uint64_t key_ = 0;
  std::uint64_t counter_ = 0;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

/// Key of one named stream of one run's seed.
std::uint64_t StreamKey(std::uint64_t seed, std::string_view stream);
/// Seed of one run of a campaign.
std::uint64_t RunSeed(std::uint64_t campaign_seed, std::uint64_t run);

}  // namespace dockyard
