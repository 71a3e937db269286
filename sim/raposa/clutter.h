// What else stands in the yard, in colours like the marks'. The camera sees it; nothing can run
// into it. So it stands clear of start, pyramid and the ways between them, and a robot that errs
// far from these drives through it.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"
#include "sim/scenario/scenery.h"

namespace dockyard::raposa {

/// How far it stays from robot, pyramid and the ways between them. Assumed, 0.4-1 m.
inline constexpr double kClutterClear_m = 0.5;

/// Up to `count` pieces within 3 m (assumed, 2-6) of the pyramid, from the seed's own stream; fewer
/// where there is no room. Every piece draws from the same numbers, whatever the others are.
/// @param X_DV      the camera at the start, x along its view
/// @param behind_m  of the ground behind the pyramid
std::vector<SceneryItem> DrawClutter(int count, const Pose2& X_DV, double behind_m,
                                     const Seed& seed);

}  // namespace dockyard::raposa
