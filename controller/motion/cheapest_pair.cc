// The search for the cheapest pair. It looks at sketches of pairs first, and solves only for those
// that may become the cheapest.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "controller/motion/pair_family.h"

namespace dockyard {
namespace {

// Even splits to look at. Between two of them nothing changes twice (tests).
constexpr int kSplits = 48;
constexpr std::size_t kPlaces = kSplits + 1 + 4;
constexpr double kZeroChange_m = 1e-14;     // of a change, where it counts as zero
constexpr double kLooseTolerance_m = 2e-9;  // wider than that of Keeps, which has the last word
// Between two places the longer arc is shorter than at both by less than this share.
constexpr double kDip = 0.1;

struct SplitTable {
  std::array<double, kSplits + 1> split_rad{}, sine{}, cosine{};
};

const SplitTable& EvenSplits() {
  static const SplitTable table = [] {
    SplitTable t;
    for (std::size_t i = 0; i <= kSplits; ++i) {
      t.split_rad[i] = static_cast<double>(i) * kPi / kSplits;
      t.sine[i] = std::sin(t.split_rad[i]);
      t.cosine[i] = std::cos(t.split_rad[i]);
    }
    return t;
  }();
  return table;
}

/// A place in the search: the pair in short, and whether each arc keeps the limits.
struct Looked {
  double split_rad = 0.0;
  bool exists = false;
  Changes changes{};  // their signs count
  std::array<double, 2> length_m{};
  std::array<bool, 2> turns_well{}, goes_well{};

  double cost_m() const { return 2.0 * std::max(std::abs(length_m[0]), std::abs(length_m[1])); }
  bool Keeps() const { return turns_well[0] && turns_well[1] && goes_well[0] && goes_well[1]; }
};

Looked Look(const PairFamily& family, const ArcLimits& limits, double split, double s, double c) {
  Looked looked;
  looked.split_rad = split;
  const std::optional<PairFamily::Sketch> sketch = family.SketchAt(s, c);
  if (!sketch) return looked;
  looked.exists = true;
  looked.length_m = sketch->length_m;
  looked.changes[0] = std::abs(sketch->length_m[0]) - std::abs(sketch->length_m[1]);
  for (std::size_t i = 0; i < 2; ++i) {
    const double spare = sketch->chord_m[i] - 2.0 * limits.least_radius_m * sketch->sine[i];
    looked.changes[1 + i] = spare;
    looked.turns_well[i] = spare >= -kLooseTolerance_m;
    if (limits.pivot_radius_m) {
      const double wide = sketch->chord_m[i] - 2.0 * *limits.pivot_radius_m * sketch->sine[i];
      looked.changes[3 + i] = wide;
      looked.turns_well[i] = looked.turns_well[i] || wide <= kLooseTolerance_m;
    }
    looked.goes_well[i] =
        limits.travel == Travel::kEither ||
        (limits.travel == Travel::kForward ? sketch->length_m[i] >= -kLooseTolerance_m
                                           : sketch->length_m[i] <= kLooseTolerance_m);
  }
  return looked;
}

std::array<Looked, kPlaces> LookAlong(const PairFamily& family, const ArcLimits& limits) {
  const SplitTable& even = EvenSplits();
  std::array<double, 4> extra = family.BesideHalfCircles();
  std::sort(extra.begin(), extra.end());
  std::array<Looked, kPlaces> places;
  std::size_t next = 0, next_extra = 0;
  const auto AddExtra = [&] {
    const double split = extra[next_extra++];
    places[next++] = Look(family, limits, split, std::sin(split), std::cos(split));
  };
  for (std::size_t i = 0; i <= kSplits; ++i) {
    while (next_extra < extra.size() && extra[next_extra] < even.split_rad[i]) AddExtra();
    places[next++] = Look(family, limits, even.split_rad[i], even.sine[i], even.cosine[i]);
  }
  while (next_extra < extra.size()) AddExtra();
  return places;
}

// Whether a zero of the change between the places may be the cheapest pair that keeps the limits.
bool Promises(const Looked& a, const Looked& b, std::size_t change, double least_m) {
  if (a.changes[change] * b.changes[change] >= 0.0) return false;
  double floor_m = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    floor_m = std::max(floor_m, std::min(std::abs(a.length_m[i]), std::abs(b.length_m[i])));
    const bool at_limit = change == 1 + i || change == 3 + i;
    const bool crosses =
        a.changes[1 + i] * b.changes[1 + i] < 0.0 || a.changes[3 + i] * b.changes[3 + i] < 0.0;
    if (!a.turns_well[i] && !b.turns_well[i] && !at_limit && !crosses) return false;
    if (!a.goes_well[i] && !b.goes_well[i]) return false;
  }
  return 2.0 * floor_m * (1.0 - kDip) < least_m;
}

// The split at which a change is zero, between two places where it has different signs: regula
// falsi, Illinois form (Dowell and Jarratt, 1971).
double ZeroOfSketches(const PairFamily& family, const ArcLimits& limits, std::size_t change,
                      const Looked& from, const Looked& to) {
  double low = from.split_rad, high = to.split_rad;
  double at_low = from.changes[change], at_high = to.changes[change];
  double zero = low;
  int kept = 0;  // the end that the last step kept: -1 low, 1 high
  for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
    zero = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_zero =
        Look(family, limits, zero, std::sin(zero), std::cos(zero)).changes[change];
    if (std::abs(at_zero) < kZeroChange_m) break;
    if ((at_zero > 0.0) == (at_high > 0.0)) {
      high = zero, at_high = at_zero;
      if (kept == -1) at_low *= 0.5;
      kept = -1;
    } else {
      low = zero, at_low = at_zero;
      if (kept == 1) at_high *= 0.5;
      kept = 1;
    }
  }
  return zero;
}

}  // namespace

std::optional<ArcPair> CheapestPair(const Pose2& X_RG, const ArcLimits& limits) {
  if (X_RG == Pose2{}) return ArcPair{};
  const PairFamily family(X_RG);
  std::optional<ArcPair> best;
  double least_m = std::numeric_limits<double>::infinity();
  const auto Offer = [&](const std::optional<ArcPair>& pair) {
    if (!pair || !Keeps(*pair, limits) || PairCost(*pair) >= least_m) return;
    best = pair;
    least_m = PairCost(*pair);
  };
  const std::array<Looked, kPlaces> places = LookAlong(family, limits);
  for (const Looked& place : places) {
    if (place.exists && place.Keeps() && place.cost_m() < least_m) {
      Offer(family.At(place.split_rad));
    }
  }
  for (std::size_t k = 1; k < kPlaces; ++k) {
    const Looked &a = places[k - 1], &b = places[k];
    if (!a.exists || !b.exists) continue;
    for (std::size_t change = 0; change < kChanges; ++change) {
      if (Promises(a, b, change, least_m)) {
        Offer(family.At(ZeroOfSketches(family, limits, change, a, b)));
      }
    }
  }
  return best;
}

}  // namespace dockyard
