// When the point comes no nearer to its target, the rover backs off and comes again by another way.
#pragma once

#include "controller/motion/arcs.h"

namespace dockyard::rocky7 {

class Retreat {
 public:
  /// A look, with the point so far off the target. True: retreat, by Next. Looks from beyond near_m
  /// tell nothing.
  bool Look(double off_m, double near_m, int most_stalls);
  /// Back to one side, then to the other, so that the rover stands aside with its old heading: one
  /// arc to the target then ends with another one, and its wheels come by other ground. The sides
  /// take turns.
  Arc Next();

 private:
  double nearest_m_ = 1e9;  // that looks have seen the point come, on this approach
  int stalls_ = 0;          // looks in a row that came no nearer
  int retreats_ = 0, steps_left_ = 0;
};

}  // namespace dockyard::rocky7
