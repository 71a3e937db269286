// Three arcs that are straight or of the least radius, in closed form. Where the shortest way of a
// car that drives both ways has three pieces (Reeds and Shepp, 1990), it is one of these.
#pragma once

#include <vector>

#include "controller/motion/three_arcs.h"

namespace dockyard {

/// Arc, arc and arc round circles on alternate sides, and arc, straight, arc; to a pose in the
/// rover's frame. Each arc takes the shorter way round that `travel` allows. With a radius of 0
/// arcs are turns in place.
std::vector<ArcTriple> ExtremeTriples(const Pose2& X_RG, double radius_m, Travel travel);

}  // namespace dockyard
