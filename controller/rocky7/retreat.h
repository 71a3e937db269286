// When the point comes no nearer to its target, the rover backs off and comes again by another
// path.
#pragma once

#include <vector>

#include "controller/geometry/rover_plan.h"
#include "controller/motion/arcs.h"

namespace dockyard::rocky7 {

class Retreat {
 public:
  /// An image pair, with the point so far off the target. True: retreat, by Next. Beyond near_m
  /// only a rover that is stuck comes no nearer: that takes more pairs.
  bool Decide(double off_m, double near_m, int most_stalls);
  bool HasArcs() const { return !arcs_.empty(); }
  /// Before the first arc: takes the other side where that is freer, and only the arcs that keep
  /// clear of the obstacles: with none the retreat is over.
  void KeepOff(const RoverPlan& rover, const Obstacles& behind_R);
  /// Back to one side, then to the other, so that the rover ends aside with its old heading: one
  /// arc to the target then ends with another one, and its wheels come by other ground. The sides
  /// take turns.
  Arc Next();

 private:
  /// On this approach.
  struct Progress {
    double nearest_m = 1e9;  // the point to the target, by image pairs
    int stalls = 0;          // pairs in a row that came no nearer
  };

  Progress far_, near_;
  double side_ = 1.0;      // left first
  std::vector<Arc> arcs_;  // to be driven
};

}  // namespace dockyard::rocky7
