#include "sim/base/random.h"

#include "controller/base/split_mix.h"
#include "sim/base/hash.h"
#include "sim/base/normal.h"

namespace dockyard {

std::uint64_t RandomStream::NextBits() { return SplitMix(key_, counter_++); }

double RandomStream::Uniform() { return static_cast<double>(NextBits() >> 11) * 0x1.0p-53; }

double RandomStream::Normal() { return NormalQuantile(OpenUnit(NextBits())); }

double OpenUnit(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1.0p-52; }

std::uint64_t StreamKey(std::uint64_t seed, std::string_view stream) {
  return MixBits(SplitMix(seed, 0) ^ HashText(kHashSeed, stream));
}

std::uint64_t PlaceSeed(std::uint64_t campaign_seed, std::uint64_t place) {
  return SplitMix(SplitMix(campaign_seed, 0), place);
}

std::uint64_t WorldSeed(std::uint64_t campaign_seed, std::uint64_t place, std::uint64_t repeat) {
  return SplitMix(PlaceSeed(campaign_seed, place), repeat);
}

}  // namespace dockyard
