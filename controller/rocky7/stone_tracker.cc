#include "controller/rocky7/stone_tracker.h"

#include <algorithm>

#include "controller/tracking/height_at.h"

namespace dockyard::rocky7 {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// A ray is not leveller than this.
constexpr double kLevel = 1e-3;
// Seen from so near the target is not another one any more. Assumed, 0.4-0.7 m.
constexpr double kSure_m = 0.55;
// Nearer than this to the cameras a stone that stands is seen. Assumed, 0.5-1 m.
constexpr double kNear_m = 0.7;
// Scoops that miss a stone push it. Assumed, 1-4 cm.
constexpr double kPushed_m = 0.02;
// What a stuck rover went less, share of its way, 1 sigma. Assumed, 0.3-0.7.
constexpr double kStuck = 0.5;
// Heaps before this share of the stone's height; assumed, 0.4-0.8.
constexpr double kHeapShare = 0.6;
// Two places of one stone are so near to each other: a share of its height, or this. Assumed,
// 0.4-0.8 and 1-2 cm.
constexpr double kAgreesShare = 0.6;
constexpr double kAgrees_m = 0.015;

bool IsKnown(const ElevationMap& closed, const Vector2d& p_E) {
  return Bilinear(closed, p_E).has_value();
}

bool Agree(const FieldStone& stone, const Vector2d& p_E) {
  return (stone.p - p_E).norm() < std::max(kAgrees_m, kAgreesShare * stone.height_m);
}

// Height of the ground about a place: that about the nearest stone, as the map shows a stone's top
// where the user clicked, or nothing.
double GroundAbout(const GroundMaps& maps, const std::vector<FieldStone>& stones,
                   const Vector2d& p_E) {
  const auto away_m = [&](const FieldStone& stone) { return (stone.p - p_E).norm(); };
  const auto nearest = std::min_element(
      stones.begin(), stones.end(),
      [&](const FieldStone& a, const FieldStone& b) { return away_m(a) < away_m(b); });
  if (nearest != stones.end()) return nearest->ground_m;
  const auto at = Bilinear(maps.closed, p_E);
  return at ? at->height_m : 0.0;
}

FieldMatch Unmatched(std::size_t stones, const Matrix2d& shift_spread_m2) {
  return {.spread_m2 = shift_spread_m2, .seen = std::vector<int>(stones, -1)};
}

}  // namespace

TargetSighting StoneTracker::Begin(const GroundMaps& maps, const Clicked& clicked) {
  field_.focal_baseline_px_m = maps.focal_baseline_px_m;
  const auto stones = StonesAbout(maps.fine, clicked.p_E, maps.p_EC, field_);
  const double ground_m = GroundAbout(maps, stones, clicked.p_E);
  const ClickRay click{.from = maps.p_EC.head<2>(),
                       .along = -clicked.ray_E.head<2>() / std::min(clicked.ray_E.z(), -kLevel),
                       .range_data = clicked.p_E,
                       .up_m = maps.p_EC.z() - ground_m,
                       .sigma_rad = clicked.sigma_rad};
  if (memory_.Begin(click, ground_m, stones)) return Found(maps, memory_.target());
  TargetSighting place = Lost("no stone is told from the ground where the user clicked");
  place.found = true;
  return place;
}

TargetSighting StoneTracker::Follow(const GroundMaps& maps, const Predicted& target) {
  const Vector2d predicted(target.X_ET.x, target.X_ET.y);
  const std::vector<FieldStone> seen = StonesAbout(maps.fine, predicted, maps.p_EC, field_);
  memory_.Turn(target.X_ET);
  FieldMatch match = MatchField(memory_.stones(), seen, target.spread_m2, field_);
  if (match.seen.front() < 0 || match.odds < field_.least_odds) {
    // A wheel may have been stuck.
    const double stuck_m = kStuck * target.way_m;
    const Matrix2d wide =
        target.spread_m2 + Matrix2d(Vector2d(stuck_m * stuck_m, 0.0).asDiagonal());
    const FieldMatch other = MatchField(memory_.stones(), seen, wide, field_);
    if (other.seen.front() >= 0 && other.odds > field_.least_odds) match = other;
  }
  if (match.odds < field_.least_odds) {
    // What is remembered fades, what is seen is remembered too: the next look may tell.
    const bool two = match.seen.front() >= 0;
    memory_.Learn(seen, Unmatched(memory_.stones().size(), target.spread_m2), field_);
    return Lost(two ? "two stones may be the target"
                    : "the target may be one of these stones or none");
  }
  memory_.Learn(seen, match, field_);
  memory_.Choose();
  const FieldStone& stone = memory_.target();
  // It was seen now where it has not been missed.
  const auto now = std::find_if(seen.begin(), seen.end(),
                                [&](const FieldStone& other) { return Agree(stone, other.p); });
  if (now != seen.end()) {
    TargetSighting found = Found(maps, *now);
    found.further_m = match.shift_m.x();
    return found;
  }
  TargetSighting lost = Lost("nothing stands out where the target should be");
  lost.gone = (lost.p_E - maps.p_EC.head<2>()).norm() < kNear_m && IsKnown(maps.closed, lost.p_E);
  return lost;
}

// Not seen, but at least where the prediction has it, among its neighbours.
TargetSighting StoneTracker::Lost(const std::string& why) {
  const FieldStone& stone = memory_.target();
  TargetSighting lost{
      .guess = true, .p_E = stone.p, .height_m = stone.ground_m + stone.height_m, .why = why};
  memory_.Shift(-lost.p_E);
  return lost;
}

// Close by, a plane through the ground about the stone alone tells its middle best.
TargetSighting StoneTracker::Found(const GroundMaps& maps, const FieldStone& target) {
  Vector2d p_E = target.p;
  double top_m = target.ground_m + target.height_m;
  StoneMiddleSettings close;
  close.window_m = 0.04;  // assumed, 3-6 cm
  close.apart_m = 0.0;
  const StoneMiddle stone = FindStone(maps.fine, p_E, close);
  if (stone.verdict == StoneVerdict::kFound && Agree(target, stone.p_E)) {
    p_E = stone.p_E;
    top_m = stone.ground.dot(Eigen::Vector3d(1.0, p_E.x(), p_E.y())) + stone.height_m;
  }
  TargetSighting seen{.found = true, .p_E = p_E, .height_m = top_m};
  const bool near = (p_E - maps.p_EC.head<2>()).norm() < kSure_m;
  if (near && memory_.HasSeenTargetWell()) memory_.Settle();
  memory_.Shift(-p_E);
  return seen;
}

TargetSighting StoneTracker::Check(const GroundMaps& maps, const Pose2& X_ET) {
  StoneMiddleSettings near;
  near.apart_m = 0.0;
  const StoneMiddle stone = FindStone(maps.fine, {X_ET.x, X_ET.y}, near);
  const bool stands = stone.verdict == StoneVerdict::kFound &&
                      stone.height_m > kHeapShare * memory_.target().height_m &&
                      !memory_.IsNeighbour(stone.p_E - Vector2d(X_ET.x, X_ET.y));
  const bool seen = stone.verdict != StoneVerdict::kUnseen;
  memory_.Loosen(kPushed_m);
  return {.found = stands,
          .gone = seen && !stands,
          .p_E = stands ? stone.p_E : Vector2d(X_ET.x, X_ET.y),
          .height_m = stone.height_m,
          .why = stands ? "the stone still stands there" : "no stone stands there any more"};
}

}  // namespace dockyard::rocky7
