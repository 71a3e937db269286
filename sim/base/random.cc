#include "sim/base/random.h"

#include <string>

#include "controller/base/split_mix.h"
#include "sim/base/hash.h"
#include "sim/base/normal.h"

namespace dockyard {

std::uint64_t RandomStream::NextBits() { return SplitMix(key_, counter_++); }

double RandomStream::Uniform() { return static_cast<double>(NextBits() >> 11) * 0x1.0p-53; }

double RandomStream::Normal() { return NormalQuantile(OpenUnit(NextBits())); }

double OpenUnit(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1.0p-52; }

std::uint64_t StreamKey(const Seed& seed, std::string_view stream) {
  if (seed.secret)
    return SealedBits(*seed.secret, std::string("stream/").append(stream), {seed.number});
  return MixBits(SplitMix(seed.number, 0) ^ HashText(kHashSeed, stream));
}

std::uint64_t PlaceKey(const Seed& campaign, std::uint64_t place, std::string_view stream) {
  if (campaign.secret) {
    return SealedBits(*campaign.secret, std::string("place/").append(stream),
                      {campaign.number, place});
  }
  return StreamKey(PlaceSeed(campaign.number, place), stream);
}

std::uint64_t RunKey(const Seed& campaign, std::uint64_t place, std::uint64_t repeat,
                     std::string_view stream) {
  if (campaign.secret) {
    return SealedBits(*campaign.secret, std::string("run/").append(stream),
                      {campaign.number, place, repeat});
  }
  return StreamKey(WorldSeed(campaign, place, repeat), stream);
}

Seed WorldSeed(const Seed& campaign, std::uint64_t place, std::uint64_t repeat) {
  if (campaign.secret) {
    return {SealedBits(*campaign.secret, "world", {campaign.number, place, repeat}),
            campaign.secret};
  }
  return WorldSeed(campaign.number, place, repeat);
}

std::uint64_t PlaceSeed(std::uint64_t campaign, std::uint64_t place) {
  return SplitMix(SplitMix(campaign, 0), place);
}

std::uint64_t WorldSeed(std::uint64_t campaign, std::uint64_t place, std::uint64_t repeat) {
  return SplitMix(PlaceSeed(campaign, place), repeat);
}

}  // namespace dockyard
