// Scenery and what throws a run's shadows, as a spectator sees them.
#pragma once

#include <vector>

#include "sim/plant/light.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// The bodies `scenery` and `shade`, posed in the world, each where there is any. The cameras see
/// no more of leaves than their shadows, which flakes throw as well; a spectator sees them green
/// and with points, each as large as its flake.
std::vector<StageBody> SurroundingBodies(const Lighting& lighting);

}  // namespace dockyard
