#include "controller/rocky7/retreat.h"

#include <algorithm>

namespace dockyard::rocky7 {
namespace {

// Nearer by less is no nearer: what is seen errs by that (docs/rocky7.md, FindStone). Assumed,
// 2-5 mm.
constexpr double kNearer_m = 0.003;
// A retreat: looks, the way between them and the arcs' radius; 0.6 m back and 0.06 m aside.
// Assumed, 3-6, 0.1-0.2 m and 1-2 m: sharper arcs get stuck in sand.
constexpr int kRetreatSteps = 4;
constexpr double kRetreatStep_m = 0.15, kRetreatRadius_m = 1.5;

}  // namespace

bool Retreat::Look(double off_m, double near_m, int most_stalls) {
  if (steps_left_ > 0) return true;
  if (off_m > near_m) {
    nearest_m_ = 1e9;
    stalls_ = 0;
    return false;
  }
  stalls_ = off_m < nearest_m_ - kNearer_m ? 0 : stalls_ + 1;
  nearest_m_ = std::min(nearest_m_, off_m);
  if (stalls_ < most_stalls) return false;
  nearest_m_ = 1e9;
  stalls_ = 0;
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
