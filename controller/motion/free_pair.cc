// The search for the cheapest free pair: even splits first, then the gaps between them halved, the
// one first that may hold the cheapest. A gap is left where every path in it is known to be
// blocked.
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "controller/motion/blocker.h"
#include "controller/motion/free_path.h"
#include "controller/motion/pair_family.h"

namespace dockyard {
namespace {

constexpr int kStops = 64;
constexpr int kEvenPlaces = 16;  // on an arc, where a path is blocked by little
constexpr double kFinest_rad = 1.5e-4;
constexpr double kEdge_rad = 1e-10;  // the same where free paths end between two places
// Between two places a length is less than at both by at most this share for a gap of pi / kStops,
// and in proportion for narrower ones.
constexpr double kGapDip = 0.1;

// A path between two others is moved by at most this times its share of what the search measures.
constexpr double kMovedMore = 1.5;

std::vector<Arc> PathOf(const ArcPair& pair) { return {pair.begin(), pair.end()}; }

/// A pair on the way along the family.
struct Stop {
  double split_rad = 0.0;
  std::optional<ArcPair> pair{};
  bool keeps = false;                // the limits
  bool is_free = false;              // keeps the demands, too
  double missing_m = 0.0;            // of the demands, where no blocker is known
  std::optional<Blocker> blocker{};  // a place at which the path is blocked
  double overlap_m = 0.0;            // there
};

/// Between two stops.
struct Gap {
  Stop from, to;
  double floor_m = 0.0;  // no pair within costs less

  bool operator<(const Gap& other) const { return floor_m > other.floor_m; }  // least first
};

double FloorOf(const Stop& a, const Stop& b) {
  double longest = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    longest = std::max(longest,
                       std::min(std::abs((*a.pair)[i].length_m), std::abs((*b.pair)[i].length_m)));
  }
  const double dip = kGapDip * std::min(1.0, (b.split_rad - a.split_rad) * kStops / kPi);
  return 2.0 * longest * (1.0 - dip);
}

/// The search along one family of pairs.
class PairSearch {
 public:
  PairSearch(const RoverPlan& rover, const Pose2& X_RG, const ArcLimits& limits,
             const PathDemands& demands)
      : rover_(rover),
        limits_(limits),
        demands_(demands),
        blockers_(rover, demands),
        family_(X_RG) {}

  std::optional<ArcPair> Cheapest(const Pose2& X_RG) {
    std::vector<ArcPair> offers;
    ForEachPair(X_RG, limits_, kStops, [&](const ArcPair& pair) { offers.push_back(pair); });
    std::sort(offers.begin(), offers.end(),
              [](const ArcPair& a, const ArcPair& b) { return PairCost(a) < PairCost(b); });
    std::vector<Blocker> known;
    for (const ArcPair& pair : offers) {
      const Stop stop = Looked({0.0, pair, true}, known);
      if (stop.blocker) known = {*stop.blocker};
      if (!stop.is_free) continue;
      Take(pair);
      break;
    }
    std::optional<Stop> last;
    for (const double split : family_.Splits(kStops)) {
      const Stop here = StopAt(split, last ? BlockersOf({*last}) : std::vector<Blocker>{});
      if (last && here.pair) Put(*last, here);
      last = here.pair ? std::optional(here) : std::nullopt;
    }
    while (!gaps_.empty() && gaps_.top().floor_m < least_m_) {
      const Gap gap = gaps_.top();
      gaps_.pop();
      const Stop middle =
          StopAt(0.5 * (gap.from.split_rad + gap.to.split_rad), BlockersOf({gap.from, gap.to}));
      if (!middle.pair) continue;
      if (middle.is_free) Take(*middle.pair);
      Put(gap.from, middle);
      Put(middle, gap.to);
    }
    return best_;
  }

 private:
  static std::vector<Blocker> BlockersOf(const std::vector<Stop>& stops) {
    std::vector<Blocker> blockers;
    for (const Stop& stop : stops) {
      if (stop.blocker) blockers.push_back(*stop.blocker);
    }
    return blockers;
  }

  // Where the limits are not kept, it does not matter what else is missing.
  Stop StopAt(double split_rad, const std::vector<Blocker>& known) const {
    Stop stop{split_rad, family_.At(split_rad)};
    stop.keeps = stop.pair && Keeps(*stop.pair, limits_);
    return stop.keeps ? Looked(stop, known) : stop;
  }

  // With what blocks the stop's path: first what blocks paths near by, as that is quick.
  Stop Looked(Stop stop, const std::vector<Blocker>& known) const {
    const std::vector<Arc> path = PathOf(*stop.pair);
    for (const Blocker& blocker : known) {
      const double overlap_m = OverlapOf(blocker, path);
      if (overlap_m <= stop.overlap_m) continue;
      stop.overlap_m = overlap_m;
      stop.blocker = blocker;
    }
    if (stop.blocker) return stop;
    stop.blocker = blockers_.Find(path, 0);
    if (!stop.blocker) {
      stop.missing_m = MissingOf(rover_, demands_, path);
      stop.is_free = stop.missing_m == 0.0;
      if (!stop.is_free) stop.blocker = blockers_.Find(path, kEvenPlaces);
    }
    if (stop.blocker) stop.overlap_m = OverlapOf(*stop.blocker, path);
    return stop;
  }

  double OverlapOf(const Blocker& blocker, const std::vector<Arc>& path) const {
    return blockers_.cover().Overlap(blocker, blockers_.cover().PoseOf(blocker, path));
  }

  void Take(const ArcPair& pair) {
    if (PairCost(pair) >= least_m_) return;
    best_ = pair;
    least_m_ = PairCost(pair);
  }

  void Put(const Stop& from, const Stop& to) {
    if (!from.keeps && !to.keeps) return;
    const double finest_rad = from.is_free == to.is_free ? kFinest_rad : kEdge_rad;
    if (to.split_rad - from.split_rad < finest_rad) return;
    const Gap gap{from, to, FloorOf(from, to)};
    if (gap.floor_m >= least_m_) return;
    if (from.keeps && to.keeps && !from.is_free && !to.is_free && IsBlocked(from, to)) return;
    gaps_.push(gap);
  }

  // Whether every path between two blocked ones is blocked: those near one as it is, the others as
  // the other is.
  bool IsBlocked(const Stop& from, const Stop& to) const {
    const auto middle = family_.At(0.5 * (from.split_rad + to.split_rad));
    if (!middle) return false;
    double share = 0.0;  // of the gap that is known to be blocked
    for (const Stop* stop : {&from, &to}) {
      const double least_m = stop->blocker ? stop->overlap_m : stop->missing_m;
      const double moved_m = Moved(stop->blocker, *from.pair, *middle, *to.pair);
      if (moved_m * kMovedMore < least_m) return true;
      share += least_m / (moved_m * kMovedMore);
    }
    return share > 1.0;
  }

  // How far any point of the rover is moved, at most, from one path by a second to a third: at the
  // blocker's place, or anywhere. The paths end at one pose, so the way lies between.
  double Moved(const std::optional<Blocker>& blocker, const ArcPair& a, const ArcPair& b,
               const ArcPair& c) const {
    std::vector<Blocker> places;
    if (blocker) {
      places = {*blocker};
    } else {
      for (const double share : {0.25, 0.5, 0.75, 1.0}) places.push_back({{}, 0, share});
      for (const double share : {0.25, 0.5, 0.75}) places.push_back({{}, 1, share});
    }
    double most = 0.0;
    for (const Blocker& place : places) {
      const double reach_m = blockers_.cover().Reach(place);
      const Pose2 p = blockers_.cover().PoseOf(place, PathOf(a)),
                  q = blockers_.cover().PoseOf(place, PathOf(b)),
                  r = blockers_.cover().PoseOf(place, PathOf(c));
      most = std::max(most, Apart(p, q, reach_m) + Apart(q, r, reach_m));
    }
    return most;
  }
  static double Apart(const Pose2& p, const Pose2& q, double reach_m) {
    return std::hypot(p.x - q.x, p.y - q.y) + reach_m * std::abs(WrapPi(p.heading - q.heading));
  }

  const RoverPlan& rover_;
  const ArcLimits& limits_;
  const PathDemands& demands_;
  BlockerSearch blockers_;
  PairFamily family_;
  std::priority_queue<Gap> gaps_;
  std::optional<ArcPair> best_;
  double least_m_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<ArcPair> CheapestFreePair(const RoverPlan& rover, const Pose2& X_RG,
                                        const ArcLimits& limits, const PathDemands& demands) {
  const auto best = CheapestPair(X_RG, limits);
  if (!best || MissingOf(rover, demands, PathOf(*best)) == 0.0) return best;
  if (IsBlockedAtAnEnd(rover, X_RG, demands)) return std::nullopt;
  return PairSearch(rover, X_RG, limits, demands).Cheapest(X_RG);
}

}  // namespace dockyard
