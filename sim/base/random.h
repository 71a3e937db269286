// Random numbers from one counter-based generator, so that each stream of each run can be drawn by
// itself and a further stream shifts no other. The draws are our own arithmetic, the same on every
// standard library.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "sim/base/secret.h"

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

/// What the draws of a campaign or of a run follow from. A plain one is a number, and whoever
/// guesses it knows all of them: each map from it to a stream can be turned back. With a secret no
/// stream follows from the number, nor from another stream.
struct Seed {
  std::uint64_t number = 1;
  std::optional<Secret> secret;

  Seed() = default;
  Seed(std::uint64_t plain) : number(plain) {}  // a number is a seed
  Seed(std::uint64_t number_, const std::optional<Secret>& secret_)
      : number(number_), secret(secret_) {}
  bool operator==(const Seed&) const = default;
};

/// Key of one named stream of one run's seed.
std::uint64_t StreamKey(const Seed& seed, std::string_view stream);
/// Key of a named stream that the runs at one place of a campaign share. A place is a point of the
/// campaign's grid or a row of its table, counted from 0.
std::uint64_t PlaceKey(const Seed& campaign, std::uint64_t place, std::string_view stream);
/// Key of a named stream of the run at that place with `repeat` others before it. Plain: that of
/// the stream of its world's seed.
std::uint64_t RunKey(const Seed& campaign, std::uint64_t place, std::uint64_t repeat,
                     std::string_view stream);
/// Seed of one run's world: the run at that place with `repeat` others before it. Place and repeat
/// are mixed one after the other, so that more places or more repeats shift no seed.
Seed WorldSeed(const Seed& campaign, std::uint64_t place, std::uint64_t repeat);
/// Those of a plain seed.
std::uint64_t PlaceSeed(std::uint64_t campaign, std::uint64_t place);
std::uint64_t WorldSeed(std::uint64_t campaign, std::uint64_t place, std::uint64_t repeat);

}  // namespace dockyard
