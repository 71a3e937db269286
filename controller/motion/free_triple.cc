// The search for three arcs: the extreme ones, and a grid of first arcs with the pairs behind them;
// then steps that make the best ones shorter.
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/motion/blocker.h"
#include "controller/motion/extreme_arcs.h"
#include "controller/motion/free_path.h"

namespace dockyard {
namespace {

constexpr int kPairSplits = 24;
constexpr int kSteps = 24;                  // of a first arc's length, either way
constexpr int kCurvatures = 2;              // of a first arc, to either side
constexpr int kPivots = 8;                  // turns on the spot that begin a path, to either side
constexpr double kHopeless = 2.0;           // times the shortest of the grid: not improved
constexpr double kFinestStep = 1e-4;        // of a step, where the improvement ends
constexpr double kSmallestRadius_m = 0.05;  // for the grid's size where a rover turns on the spot

struct Found {
  double length_m = 0.0;
  ArcTriple arcs{};
};

double LengthOf(const ArcTriple& arcs) {
  return std::abs(arcs[0].length_m) + std::abs(arcs[1].length_m) + std::abs(arcs[2].length_m);
}

// Of one curvature and driven the same way.
bool AreOfOneKind(const Arc& a, const Arc& b) {
  return (a.length_m >= 0.0) == (b.length_m >= 0.0) &&
         std::abs(a.turn_rad * b.length_m - b.turn_rad * a.length_m) <
             1e-9 * (1.0 + std::abs(a.length_m * b.length_m));
}

class TripleSearch {
 public:
  TripleSearch(const RoverPlan& rover, const Pose2& X_RG, const ArcLimits& limits,
               const PathDemands& demands)
      : rover_(rover), X_RG_(X_RG), limits_(limits), demands_(demands), blockers_(rover, demands) {}

  std::optional<ArcTriple> Shortest() const {
    std::vector<Found> best = BestOfGrid();
    std::optional<Found> shortest;
    for (const Found& found : best) {
      const Found improved = Improved(found);
      if (!shortest || improved.length_m < shortest->length_m) shortest = improved;
    }
    if (!shortest) return std::nullopt;
    return shortest->arcs;
  }

 private:
  std::vector<Arc> Firsts() const {
    const double radius_m = std::max(limits_.least_radius_m, kSmallestRadius_m);
    const double longest_m = std::hypot(X_RG_.x, X_RG_.y) + kPi * radius_m;
    std::vector<Arc> firsts = FirstArcs(limits_, longest_m / kSteps, longest_m, kCurvatures);
    const bool pivots = limits_.pivot_radius_m || limits_.least_radius_m == 0.0;
    const double pivot_m = limits_.pivot_radius_m.value_or(0.0);
    for (int i = 1; pivots && i <= kPivots; ++i) {
      const double turn = kPi * i / kPivots;
      for (const double side : {-1.0, 1.0}) {
        for (const double way : {-1.0, 1.0}) {
          const Arc arc{way * pivot_m * turn, side * turn};
          if (Keeps(arc, limits_)) firsts.push_back(arc);
        }
      }
    }
    return firsts;
  }

  bool IsFree(const ArcTriple& arcs) const {
    const std::vector<Arc> path(arcs.begin(), arcs.end());
    return !blockers_.Find(path, 0) && MissingOf(rover_, demands_, path) == 0.0;
  }

  // The shortest free path of the grid for each kind of first arc: those of one curvature and one
  // way. Each kind has its own shortest path near by.
  std::vector<Found> BestOfGrid() const {
    std::vector<Found> all;
    double enough_m = std::numeric_limits<double>::infinity();
    for (const ArcTriple& arcs : ExtremeTriples(X_RG_, limits_.least_radius_m, limits_.travel)) {
      const double length_m = LengthOf(arcs);
      all.push_back({length_m, arcs});
      if (length_m < enough_m && IsFree(arcs)) enough_m = length_m;
    }
    ForEachTriple(
        X_RG_, Firsts(), limits_, kPairSplits,
        [&](const Arc& first) { return std::abs(first.length_m) < enough_m; },
        [&](const ArcTriple& arcs) {
          all.push_back({LengthOf(arcs), arcs});
        });
    std::sort(all.begin(), all.end(),
              [](const Found& a, const Found& b) { return a.length_m < b.length_m; });
    std::vector<Found> best;
    for (const Found& found : all) {
      if (!best.empty() && found.length_m > kHopeless * best.front().length_m) break;
      const bool known = std::any_of(best.begin(), best.end(), [&](const Found& other) {
        return AreOfOneKind(other.arcs[0], found.arcs[0]);
      });
      if (!known && IsFree(found.arcs)) best.push_back(found);
    }
    return best;
  }

  // The shortest free path with this first arc that is shorter than the one given.
  std::optional<Found> Shorter(const Arc& first, double length_m) const {
    std::vector<Found> shorter;
    if (!Keeps(first, limits_)) return std::nullopt;
    ForEachTriple(
        X_RG_, {first}, limits_, kPairSplits, [](const Arc&) { return true; },
        [&](const ArcTriple& arcs) {
          const double length = LengthOf(arcs);
          if (length < length_m) shorter.push_back({length, arcs});
        });
    std::sort(shorter.begin(), shorter.end(),
              [](const Found& a, const Found& b) { return a.length_m < b.length_m; });
    for (const Found& found : shorter) {
      if (IsFree(found.arcs)) return found;
    }
    return std::nullopt;
  }

  // Steps of the first arc's length and turn, ever smaller.
  Found Improved(Found found) const {
    const double radius_m = std::max(limits_.least_radius_m, kSmallestRadius_m);
    const double whole_m = std::hypot(X_RG_.x, X_RG_.y) + kPi * radius_m;
    for (double step = 0.5 / kSteps; step > kFinestStep;) {
      bool better = false;
      const Arc at = found.arcs[0];
      const double along_m = step * whole_m, about_rad = along_m / radius_m;
      const double curvature = at.length_m == 0.0 ? 0.0 : at.turn_rad / at.length_m;
      for (const Arc& next :
           {Arc{at.length_m + along_m, curvature * (at.length_m + along_m)},
            Arc{at.length_m - along_m, curvature * (at.length_m - along_m)},
            Arc{at.length_m, at.turn_rad + about_rad}, Arc{at.length_m, at.turn_rad - about_rad}}) {
        const std::optional<Found> shorter = Shorter(next, found.length_m);
        if (!shorter) continue;
        found = *shorter;
        better = true;
        break;
      }
      if (!better) step *= 0.5;
    }
    return found;
  }

  const RoverPlan& rover_;
  Pose2 X_RG_;
  const ArcLimits& limits_;
  const PathDemands& demands_;
  BlockerSearch blockers_;
};

}  // namespace

std::optional<ArcTriple> ShortestFreeTriple(const RoverPlan& rover, const Pose2& X_RG,
                                            const ArcLimits& limits, const PathDemands& demands) {
  if (X_RG == Pose2{}) return ArcTriple{};
  if (IsBlockedAtAnEnd(rover, X_RG, demands)) return std::nullopt;
  return TripleSearch(rover, X_RG, limits, demands).Shortest();
}

}  // namespace dockyard
