#include "sim/draws/design.h"

#include <bit>
#include <cmath>
#include <set>

#include "controller/base/check.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

/// A number in stratum `stratum` of `strata`. It is (stratum + share) / strata with few enough
/// digits in the share that rounding cannot carry it over an end: times `strata` and rounded down
/// it gives the stratum again.
double InStratum(std::uint64_t stratum, std::uint64_t strata, std::uint64_t bits) {
  const int digits = 50 - static_cast<int>(std::bit_width(strata - 1));
  const double share = std::ldexp(static_cast<double>(bits >> (64 - digits)) + 0.5, -digits);
  return (static_cast<double>(stratum) + share) / static_cast<double>(strata);
}

}  // namespace

Design::Design(DesignKind kind, std::uint64_t repeats, const Seed& campaign,
               const std::vector<std::string>& keys)
    : kind_(kind),
      repeats_(repeats),
      campaign_(campaign),
      sobol_(kind == DesignKind::kSobol ? SobolPoints(keys.size(), repeats) : SobolPoints(0, 0)) {
  DOCKYARD_CHECK(kind == DesignKind::kMonteCarlo || (repeats >= 1 && repeats <= kMostRepeats));
  DOCKYARD_CHECK(std::set<std::string>(keys.begin(), keys.end()).size() == keys.size());
  const std::string at_place = kind == DesignKind::kSobol ? "shift/" : "strata/";
  for (const std::string& key : keys) streams_.push_back({"draw/" + key, at_place + key});
}

double Design::Uniform(std::size_t key, std::uint64_t place, std::uint64_t repeat) const {
  DOCKYARD_CHECK(key < streams_.size());
  DOCKYARD_CHECK(kind_ == DesignKind::kMonteCarlo || repeat < repeats_);
  const Streams& streams = streams_[key];
  const auto at_run = [&] {
    return RandomStream(RunKey(campaign_, place, repeat, streams.run)).NextBits();
  };
  const auto at_place = [&] { return PlaceKey(campaign_, place, streams.place); };
  switch (kind_) {
    case DesignKind::kMonteCarlo:
      return OpenUnit(at_run());
    case DesignKind::kLatinHypercube:
      return InStratum(Permuted(repeat, repeats_, at_place()), repeats_, at_run());
    case DesignKind::kSobol:
      return OpenUnit(sobol_.Digits(key, repeat) ^ at_place());
  }
  DOCKYARD_CHECK(false);
  return 0.0;
}

}  // namespace dockyard
