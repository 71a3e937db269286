// Two arcs to a pose, after Nesnas, Maimone and Das (ICRA 2000), equations (4)-(14). The pairs that
// reach a pose are a family of one parameter. The paper takes a radius for it. Here it is the ratio
// of the two chords: straight parts, parts of one circle and turns in place are ordinary points of
// it, and every pair whose arcs turn by half a circle at most appears once.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "controller/geometry/pose.h"
#include "controller/motion/arcs.h"

namespace dockyard {

/// Which way an arc may be driven.
enum class Travel { kEither, kForward, kBackward };

/// Sharper arcs turn standing wheels far, which pushes the rover aside. Assumed, 0.7-1.5 m.
inline constexpr double kGentleRadius_m = 1.0;

struct ArcLimits {
  double least_radius_m = 0.0;  // of every arc; 0: turns in place are allowed
  Travel travel = Travel::kEither;
  /// Arcs that turn at least this tightly are allowed as well: wheels that steer past the centre
  /// line let a rover turn nearly in place, but not on the radii between. None: they are not.
  std::optional<double> pivot_radius_m{};
};

using ArcPair = std::array<Arc, 2>;

/// Whether the arc keeps the limits, to 1e-9 m.
bool Keeps(const Arc& arc, const ArcLimits& limits);
bool Keeps(const ArcPair& pair, const ArcLimits& limits);

/// The pair to a pose in the rover's frame whose signed chords are as sin(split_rad) to
/// cos(split_rad), split_rad in [0, pi). None where the goal is at the rover's own place: two arcs
/// only turn in place there. None near a split of 3/4 pi with the goal's heading near 0, where the
/// chords grow beyond 1e3 times the way.
std::optional<ArcPair> PairOfSplit(const Pose2& X_RG, double split_rad);

/// Eq. (14): twice the longer of the two [m].
double PairCost(const ArcPair& pair);

/// Calls look for pairs that keep the limits: those of `splits` even splits, and those at the edges
/// of what the limits let through, where the cheapest often lies.
void ForEachPair(const Pose2& X_RG, const ArcLimits& limits, int splits,
                 const std::function<void(const ArcPair&)>& look);

/// The pair of least cost within the limits; none when no pair keeps them. Two arcs of no length
/// for the rover's own pose.
std::optional<ArcPair> CheapestPair(const Pose2& X_RG, const ArcLimits& limits);

}  // namespace dockyard
