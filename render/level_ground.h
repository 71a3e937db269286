// A level ground in a flat view. No GL.
#pragma once

#include "render/flat_view.h"
#include "render/scene.h"

namespace dockyard {

/// Adds it to what the view holds, in front or behind. All heights are the same, so it is a plane,
/// whose 1/z is linear in the tan plane: no triangles are needed. X_WV: the view.
void AddLevelGround(const GroundView& ground, const Pose3& X_WV, FlatView& view);

}  // namespace dockyard
