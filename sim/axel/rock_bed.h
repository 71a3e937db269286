// The rocks of a world, fixed in its ground.
#pragma once

#include <vector>

#include "sim/rigid/convex_body.h"

namespace dockyard::axel {

struct RockBed {
  std::vector<ConvexBody> rocks;  // in the site frame G
  double friction = 0.6;          // of the rover on them; assumed, 0.3-0.8
};

}  // namespace dockyard::axel
