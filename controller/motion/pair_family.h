// The pairs of arcs to one goal, by the ratio of their chords (two_arcs.h), and where the cheapest
// of them may be.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "controller/motion/two_arcs.h"

namespace dockyard {

/// The family of pairs to one goal.
class PairFamily {
 public:
  explicit PairFamily(const Pose2& X_RG);

  std::optional<ArcPair> At(double split_rad) const;

  /// What a search needs of a pair: lengths [m] with their signs, and without sign the chords [m]
  /// and the sines of half the turns. An arc's radius is chord / (2 sine).
  struct Sketch {
    std::array<double, 2> length_m{}, chord_m{}, sine{};
  };
  /// As At, but four times as fast. From sine and cosine of the split.
  std::optional<Sketch> SketchAt(double sine, double cosine) const;

  /// Both sides of the splits at which the first or the second arc is half a circle. It may be
  /// driven either way round there. Within [0, pi], not in order.
  std::array<double, 4> BesideHalfCircles() const;
  /// Even splits from 0 to pi and those beside half circles, in order.
  std::vector<double> Splits(int even) const;

 private:
  double distance_m_, bearing_, half_, sin_half_, cos_half_, sin_bearing_, cos_bearing_;
};

/// What changes its sign where a pair may be the cheapest: 0, the longer arc becomes the other one;
/// 1 and 2, an arc comes to the least radius; 3 and 4, to the pivot's.
constexpr std::size_t kChanges = 5;
using Changes = std::array<double, kChanges>;

}  // namespace dockyard
