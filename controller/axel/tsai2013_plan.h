// What the rover of Tsai, Nesnas and Zarzhitsky (2013, IV) does next: a pure function of the pose
// that its last sighting gave.
#pragma once

#include <vector>

#include "controller/axel/nominal/tsai2013_options.h"
#include "controller/axel/planner.h"
#include "controller/motion/arcs.h"

namespace dockyard::axel {

enum class Tsai2013Step {
  kApproach,  // an S to the border of the alignment region
  kAlign,     // an S to before the mouth
  kMate,      // an S to the contact, slower
  kReel,      // at contact: wheels free, the spool reels in
  kRecover,   // backwards to the recovery goal
};

struct Tsai2013Plan {
  Tsai2013Step step = Tsai2013Step::kApproach;
  std::vector<Arc> arcs;
};

/// The regions of Fig. 7 with the gate of V-B. No forward S to the goal within the limits, or in
/// the mating region a misalignment, sends the rover back to the recovery goal. Where the mating
/// has no S to the contact, it drives straight on if that brings the tip into the mouth.
Tsai2013Plan PlanTsai2013(const PlanGeometry& geometry, const Tsai2013Options& options,
                          const Pose2& X_DR);

/// By how much the exposed tether shortens over each arc, after Eq. (1): arm, rover's distance and
/// alpha - h.
std::vector<double> TetherShortening(double arm_m, const Pose2& X_DR_start,
                                     const std::vector<Arc>& arcs);

}  // namespace dockyard::axel
