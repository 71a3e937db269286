#include <cmath>

#include "controller/base/check.h"
#include "controller/motion/pair_family.h"

namespace dockyard {
namespace {

constexpr double kZero_m = 1e-13;  // of a change, where it counts as zero

// A split, and what changes there.
struct Place {
  double split_rad = 0.0;
  Changes changes{};
};

Changes ChangesOf(const ArcPair& pair, const ArcLimits& limits) {
  const auto Spare = [&](const Arc& arc, double radius_m) {
    return std::abs(arc.length_m) - radius_m * std::abs(arc.turn_rad);
  };
  Changes changes{std::abs(pair[0].length_m) - std::abs(pair[1].length_m),
                  Spare(pair[0], limits.least_radius_m), Spare(pair[1], limits.least_radius_m)};
  if (limits.pivot_radius_m) {
    changes[3] = Spare(pair[0], *limits.pivot_radius_m);
    changes[4] = Spare(pair[1], *limits.pivot_radius_m);
  }
  return changes;
}

// The split at which a change is zero, between two places where it has different signs: regula
// falsi. Each step halves the change at the end that it keeps, which costs steps: the search for
// the cheapest pair has a quicker one. This one stays, as every plan holds its last bits.
double ZeroBetween(const PairFamily& family, const ArcLimits& limits, std::size_t which,
                   const Place& from, const Place& to) {
  double low = from.split_rad, high = to.split_rad;
  double at_low = from.changes[which], at_high = to.changes[which];
  double zero = low;
  for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
    zero = (low * at_high - high * at_low) / (at_high - at_low);
    const std::optional<ArcPair> pair = family.At(zero);
    const double at_zero = pair ? ChangesOf(*pair, limits)[which] : 0.0;
    if (std::abs(at_zero) < kZero_m) break;
    if ((at_zero > 0.0) == (at_high > 0.0)) {
      high = zero, at_high = at_zero;
      at_low *= 0.5;
    } else {
      low = zero, at_low = at_zero;
      at_high *= 0.5;
    }
  }
  return zero;
}

}  // namespace

std::optional<ArcPair> PairOfSplit(const Pose2& X_RG, double split_rad) {
  return PairFamily(X_RG).At(split_rad);
}

void ForEachPair(const Pose2& X_RG, const ArcLimits& limits, int splits,
                 const std::function<void(const ArcPair&)>& look) {
  DOCKYARD_CHECK(splits > 0 && limits.least_radius_m >= 0.0);
  const PairFamily family(X_RG);
  const auto Offer = [&](const std::optional<ArcPair>& pair) {
    if (pair && Keeps(*pair, limits)) look(*pair);
  };
  std::optional<ArcPair> last;
  Place before;
  for (const double split : family.Splits(splits)) {
    const std::optional<ArcPair> pair = family.At(split);
    Offer(pair);
    const Place here{split, pair ? ChangesOf(*pair, limits) : Changes{}};
    for (std::size_t i = 0; pair && last && i < kChanges; ++i) {
      if (here.changes[i] * before.changes[i] >= 0.0) continue;
      Offer(family.At(ZeroBetween(family, limits, i, before, here)));
    }
    last = pair;
    before = here;
  }
}

}  // namespace dockyard
