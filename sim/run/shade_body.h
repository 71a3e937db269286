// What throws a run's shadows, as a spectator sees it.
#pragma once

#include <vector>

#include "sim/plant/light.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// The body `shade`, posed in the world; none where nothing throws shadows but the robot and its
/// target. The cameras see no more of leaves than their shadows, which flakes throw as well; a
/// spectator sees them green and with points, each as large as its flake.
std::vector<StageBody> ShadeBodies(const Lighting& lighting);

}  // namespace dockyard
