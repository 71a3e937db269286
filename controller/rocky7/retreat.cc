#include "controller/rocky7/retreat.h"

#include <algorithm>

namespace dockyard::rocky7 {
namespace {

// Nearer by less is no nearer: what is seen errs by that (docs/rocky7.md, FindStone). Assumed,
// 2-5 mm.
constexpr double kNearer_m = 0.003;
// Further away: a fifth of a step, and pairs in a row. Assumed, 1-4 cm and 3-6.
constexpr double kFarNearer_m = 0.02;
constexpr int kMostFarStalls = 4;
// A retreat: looks, the way between them and the arcs' radius; 0.6 m back and 0.06 m aside.
// Assumed, 3-6, 0.1-0.2 m and 1-2 m: sharper arcs get stuck in sand.
constexpr int kRetreatSteps = 4;
constexpr double kRetreatStep_m = 0.15, kRetreatRadius_m = 1.5;

}  // namespace

bool Retreat::Look(double off_m, double near_m, int most_stalls) {
  if (steps_left_ > 0) return true;
  const bool is_far = off_m > near_m;
  Progress& progress = is_far ? far_ : near_;
  if (is_far) near_ = {};
  const double nearer_m = is_far ? kFarNearer_m : kNearer_m;
  progress.stalls = off_m < progress.nearest_m - nearer_m ? 0 : progress.stalls + 1;
  progress.nearest_m = std::min(progress.nearest_m, off_m);
  if (progress.stalls < (is_far ? kMostFarStalls : most_stalls)) return false;
  far_ = near_ = {};
  ++retreats_;
  steps_left_ = kRetreatSteps;
  return true;
}

Arc Retreat::Next() {
  const bool first_half = 2 * steps_left_ > kRetreatSteps;
  --steps_left_;
  const double side = (retreats_ % 2 == 0) == first_half ? 1.0 : -1.0;
  return {-kRetreatStep_m, side * kRetreatStep_m / kRetreatRadius_m};
}

}  // namespace dockyard::rocky7
