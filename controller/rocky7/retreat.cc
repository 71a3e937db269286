#include "controller/rocky7/retreat.h"

#include <algorithm>

#include "controller/motion/clearance.h"

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
// From what is behind. Assumed, 2-5 cm.
constexpr double kClear_m = 0.03;

// Half of the arcs to one side, half to the other.
std::vector<Arc> AsideTo(double side) {
  std::vector<Arc> arcs;
  for (int i = 0; i < kRetreatSteps; ++i) {
    const double turn_rad = side * kRetreatStep_m / kRetreatRadius_m;
    arcs.push_back({-kRetreatStep_m, 2 * i < kRetreatSteps ? turn_rad : -turn_rad});
  }
  return arcs;
}

}  // namespace

bool Retreat::Decide(double off_m, double near_m, int most_stalls) {
  if (HasArcs()) return true;
  const bool is_far = off_m > near_m;
  Progress& progress = is_far ? far_ : near_;
  if (is_far) near_ = {};
  const double nearer_m = is_far ? kFarNearer_m : kNearer_m;
  progress.stalls = off_m < progress.nearest_m - nearer_m ? 0 : progress.stalls + 1;
  progress.nearest_m = std::min(progress.nearest_m, off_m);
  if (progress.stalls < (is_far ? kMostFarStalls : most_stalls)) return false;
  far_ = near_ = {};
  side_ = -side_;
  arcs_ = AsideTo(side_);
  return true;
}

void Retreat::KeepOff(const RoverPlan& rover, const Obstacles& behind_R) {
  const auto shorten = [&](std::vector<Arc>& path) {
    while (!path.empty() && Clearance(rover, path, behind_R, kClear_m) < kClear_m) path.pop_back();
  };
  const std::size_t all = arcs_.size();
  std::vector<Arc> others = arcs_;
  for (Arc& arc : others) arc.turn_rad = -arc.turn_rad;
  shorten(arcs_);
  shorten(others);
  if (arcs_.size() == all || others.size() <= arcs_.size()) return;
  arcs_ = others;
  side_ = -side_;
}

Arc Retreat::Next() {
  const Arc next = arcs_.front();
  arcs_.erase(arcs_.begin());
  return next;
}

}  // namespace dockyard::rocky7
