#include "controller/motion/free_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "controller/base/check.h"
#include "controller/motion/keep_in_view.h"
#include "controller/motion/pair_family.h"

namespace dockyard {
namespace {

constexpr int kStops = 64;
constexpr double kFinest_rad = 1.5e-4;
constexpr double kEdge_rad = 1e-12;  // the same where free paths end between two places
// Between two places a length is less than at both by at most this share for a gap of pi / kStops,
// and in proportion for narrower ones.
constexpr double kGapDip = 0.1;

// A path between two others is moved by at most this times what MovedBetween finds.
constexpr double kMovedMore = 1.5;

std::vector<Arc> PathOf(const ArcPair& pair) { return {pair.begin(), pair.end()}; }

/// A pair on the way along the family.
struct Stop {
  double split_rad = 0.0;
  std::optional<ArcPair> pair{};
  bool keeps = false;      // the limits
  double missing_m = 0.0;  // of the demands
};

bool IsFree(const Stop& stop) { return stop.keeps && stop.missing_m == 0.0; }

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

// How far any point of the rover is moved, at most, by going from one path to the other; reach_m
// from R to its farthest point. Both end at the same pose, so the way lies between.
double MovedBetween(const ArcPair& a, const ArcPair& b, double reach_m) {
  double most = 0.0;
  const auto Look = [&](const Pose2& p, const Pose2& q) {
    most = std::max(
        most, std::hypot(p.x - q.x, p.y - q.y) + reach_m * std::abs(WrapPi(p.heading - q.heading)));
  };
  const Pose2 joint_a = Advance({}, a[0]), joint_b = Advance({}, b[0]);
  Look(joint_a, joint_b);
  for (const double share : {0.25, 0.5, 0.75}) {
    Look(Advance({}, Part(a[0], share)), Advance({}, Part(b[0], share)));
    Look(Advance(joint_a, Part(a[1], share)), Advance(joint_b, Part(b[1], share)));
  }
  return most;
}

double ReachOf(const RoverPlan& rover) {
  double reach = 0.0;
  for (const Polygon& part : OutlineOn(rover, {1.0, 0.0})) {
    for (const Eigen::Vector2d& corner : part) reach = std::max(reach, corner.norm());
  }
  return reach;
}

/// The search along one family of pairs.
class PairSearch {
 public:
  PairSearch(const RoverPlan& rover, const Pose2& X_RG, const ArcLimits& limits,
             const PathDemands& demands)
      : rover_(rover),
        limits_(limits),
        demands_(demands),
        family_(X_RG),
        reach_m_(ReachOf(rover)) {}

  std::optional<ArcPair> Cheapest(const Pose2& X_RG) {
    std::vector<ArcPair> offers;
    ForEachPair(X_RG, limits_, kStops, [&](const ArcPair& pair) { offers.push_back(pair); });
    std::sort(offers.begin(), offers.end(),
              [](const ArcPair& a, const ArcPair& b) { return PairCost(a) < PairCost(b); });
    for (const ArcPair& pair : offers) {
      if (MissingOf(rover_, demands_, PathOf(pair)) > 0.0) continue;
      Take(pair);
      break;
    }
    std::optional<Stop> last;
    for (const double split : family_.Splits(kStops)) {
      const Stop here = StopAt(split);
      if (last && here.pair) Put(*last, here);
      last = here.pair ? std::optional(here) : std::nullopt;
    }
    while (!gaps_.empty() && gaps_.top().floor_m < least_m_) {
      const Gap gap = gaps_.top();
      gaps_.pop();
      const Stop middle = StopAt(0.5 * (gap.from.split_rad + gap.to.split_rad));
      if (!middle.pair) continue;
      if (IsFree(middle)) Take(*middle.pair);
      Put(gap.from, middle);
      Put(middle, gap.to);
    }
    return best_;
  }

 private:
  // Where the limits are not kept, it does not matter what else is missing.
  Stop StopAt(double split_rad) const {
    Stop stop{split_rad, family_.At(split_rad)};
    stop.keeps = stop.pair && Keeps(*stop.pair, limits_);
    if (stop.keeps) stop.missing_m = MissingOf(rover_, demands_, PathOf(*stop.pair));
    return stop;
  }
  void Take(const ArcPair& pair) {
    if (PairCost(pair) >= least_m_) return;
    best_ = pair;
    least_m_ = PairCost(pair);
  }
  void Put(const Stop& from, const Stop& to) {
    if (!from.keeps && !to.keeps) return;
    const double finest_rad = IsFree(from) == IsFree(to) ? kFinest_rad : kEdge_rad;
    if (to.split_rad - from.split_rad < finest_rad) return;
    const Gap gap{from, to, FloorOf(from, to)};
    if (gap.floor_m >= least_m_) return;
    if (from.keeps && to.keeps && from.missing_m > 0.0 && to.missing_m > 0.0) {
      const double moved_m = MovedBetween(*from.pair, *to.pair, reach_m_);
      if (from.missing_m + to.missing_m > kMovedMore * moved_m) return;
    }
    gaps_.push(gap);
  }

  const RoverPlan& rover_;
  const ArcLimits& limits_;
  const PathDemands& demands_;
  PairFamily family_;
  double reach_m_;
  std::priority_queue<Gap> gaps_;
  std::optional<ArcPair> best_;
  double least_m_ = std::numeric_limits<double>::infinity();
};

}  // namespace

double MissingOf(const RoverPlan& rover, const PathDemands& demands, const std::vector<Arc>& path) {
  double missing_m = 0.0;
  if (demands.p_AT) {
    DOCKYARD_CHECK(rover.view);
    missing_m = std::max(missing_m, -SpareInView(*rover.view, path, *demands.p_AT));
  }
  const double clear_m = Clearance(rover, path, demands.obstacles, demands.margin_m);
  return std::max(missing_m, demands.margin_m - clear_m);
}

bool IsBlockedAtAnEnd(const RoverPlan& rover, const Pose2& X_RG, const PathDemands& demands) {
  for (const Pose2& X_AR : {Pose2{}, X_RG}) {
    const double clear_m = StandingClearance(rover, X_AR, demands.obstacles, demands.margin_m);
    if (clear_m < demands.margin_m) return true;
    if (demands.p_AT && SpareInView(*rover.view, {Arc{}}, Inverse(X_AR) * *demands.p_AT) < 0.0) {
      return true;
    }
  }
  return false;
}

std::optional<ArcPair> CheapestFreePair(const RoverPlan& rover, const Pose2& X_RG,
                                        const ArcLimits& limits, const PathDemands& demands) {
  const auto best = CheapestPair(X_RG, limits);
  if (!best || MissingOf(rover, demands, PathOf(*best)) == 0.0) return best;
  if (IsBlockedAtAnEnd(rover, X_RG, demands)) return std::nullopt;
  return PairSearch(rover, X_RG, limits, demands).Cheapest(X_RG);
}

}  // namespace dockyard
