#include "controller/motion/two_arcs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr double kTolerance_m = 1e-9;
constexpr double kZero_m = 1e-13;  // of a change, where it counts as zero
// Even splits at which CheapestPair looks; between two of them nothing changes twice (tests).
constexpr int kSplits = 48;
// On either side of a split at which an arc is half a circle, and may be driven either way round.
constexpr double kBeside = 1e-13;

// Arc length over chord, by half the turn.
double ArcOverChord(double half_turn) {
  return std::abs(half_turn) < 1e-4 ? 1.0 + half_turn * half_turn / 6.0
                                    : half_turn / std::sin(half_turn);
}

// The arc along a signed chord, its half turn brought within a quarter of a circle either way.
Arc AlongChord(double chord_m, double half_turn) {
  const double halves = std::round(half_turn / kPi);
  if (std::fmod(std::abs(halves), 2.0) == 1.0) chord_m = -chord_m;
  half_turn -= halves * kPi;
  return {chord_m * ArcOverChord(half_turn), 2.0 * half_turn};
}

/// The family of pairs to one goal.
class Family {
 public:
  explicit Family(const Pose2& X_RG)
      : distance_m_(std::hypot(X_RG.x, X_RG.y)),
        bearing_(std::atan2(X_RG.y, X_RG.x)),
        half_(0.5 * X_RG.heading),
        sin_half_(std::sin(half_)),
        cos_half_(std::cos(half_)) {}

  std::optional<ArcPair> At(double split_rad) const {
    const double s = std::sin(split_rad), c = std::cos(split_rad);
    // Square of the way by both chords, in chords: |s + c e^(i half)|^2.
    const double way = 1.0 + 2.0 * s * c * cos_half_;
    if (distance_m_ == 0.0 || way < 1e-6) return std::nullopt;
    const double scale_m = distance_m_ / std::sqrt(way);
    const double first_half = bearing_ - std::atan2(c * sin_half_, s + c * cos_half_);
    return ArcPair{AlongChord(scale_m * s, first_half),
                   AlongChord(scale_m * c, half_ - first_half)};
  }

  /// Even splits, and both sides of those at which an arc is half a circle.
  std::vector<double> Splits(int even) const {
    std::vector<double> splits;
    for (int i = 0; i <= even; ++i) splits.push_back(i * kPi / even);
    const double turned = half_ - bearing_;
    for (const double half_circle : {std::atan2(-std::cos(turned), std::cos(bearing_)),
                                     std::atan2(-std::cos(half_ + turned), std::cos(turned))}) {
      const double split = half_circle < 0.0 ? half_circle + kPi : half_circle;
      splits.push_back(std::max(0.0, split - kBeside));
      splits.push_back(std::min(kPi, split + kBeside));
    }
    std::sort(splits.begin(), splits.end());
    return splits;
  }

 private:
  double distance_m_, bearing_, half_, sin_half_, cos_half_;
};

// What changes its sign where a pair may be the cheapest: the longer arc becomes the other one, or
// an arc comes to its limit of radius.
using Changes = std::array<double, 3>;
Changes ChangesOf(const ArcPair& pair, double least_radius_m) {
  const auto Spare = [&](const Arc& arc) {
    return std::abs(arc.length_m) - least_radius_m * std::abs(arc.turn_rad);
  };
  return {std::abs(pair[0].length_m) - std::abs(pair[1].length_m), Spare(pair[0]), Spare(pair[1])};
}

// The split at which a change is zero, between two of different sign: regula falsi, Illinois form
// (Dowell and Jarratt, 1971).
double ZeroBetween(const Family& family, double least_radius_m, std::size_t which, double low,
                   double at_low, double high, double at_high) {
  double zero = low;
  for (int i = 0; i < 60 && high - low > 1e-15; ++i) {
    zero = (low * at_high - high * at_low) / (at_high - at_low);
    const std::optional<ArcPair> pair = family.At(zero);
    const double at_zero = pair ? ChangesOf(*pair, least_radius_m)[which] : 0.0;
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

bool Keeps(const Arc& arc, const ArcLimits& limits) {
  if (limits.travel == Travel::kForward && arc.length_m < -kTolerance_m) return false;
  if (limits.travel == Travel::kBackward && arc.length_m > kTolerance_m) return false;
  return std::abs(arc.length_m) + kTolerance_m >= limits.least_radius_m * std::abs(arc.turn_rad);
}

bool Keeps(const ArcPair& pair, const ArcLimits& limits) {
  return Keeps(pair[0], limits) && Keeps(pair[1], limits);
}

std::optional<ArcPair> PairOfSplit(const Pose2& X_RG, double split_rad) {
  return Family(X_RG).At(split_rad);
}

double PairCost(const ArcPair& pair) {
  return 2.0 * std::max(std::abs(pair[0].length_m), std::abs(pair[1].length_m));
}

void ForEachPair(const Pose2& X_RG, const ArcLimits& limits, int splits,
                 const std::function<void(const ArcPair&)>& look) {
  DOCKYARD_CHECK(splits > 0 && limits.least_radius_m >= 0.0);
  const Family family(X_RG);
  const auto Offer = [&](const std::optional<ArcPair>& pair) {
    if (pair && Keeps(*pair, limits)) look(*pair);
  };
  std::optional<ArcPair> last;
  double last_split = 0.0;
  Changes last_changes{};
  for (const double split : family.Splits(splits)) {
    const std::optional<ArcPair> pair = family.At(split);
    Offer(pair);
    const Changes changes = pair ? ChangesOf(*pair, limits.least_radius_m) : Changes{};
    for (std::size_t i = 0; pair && last && i < changes.size(); ++i) {
      if (changes[i] * last_changes[i] >= 0.0) continue;
      Offer(family.At(ZeroBetween(family, limits.least_radius_m, i, last_split, last_changes[i],
                                  split, changes[i])));
    }
    last = pair;
    last_split = split;
    last_changes = changes;
  }
}

std::optional<ArcPair> CheapestPair(const Pose2& X_RG, const ArcLimits& limits) {
  if (X_RG == Pose2{}) return ArcPair{};
  std::optional<ArcPair> best;
  ForEachPair(X_RG, limits, kSplits, [&](const ArcPair& pair) {
    if (!best || PairCost(pair) < PairCost(*best)) best = pair;
  });
  return best;
}

}  // namespace dockyard
