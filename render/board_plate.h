// The board's white plate as a mesh: flat with the hole for the docking cone, or bent.
#pragma once

#include "render/scene.h"
#include "render/surface_mesh.h"

namespace dockyard {

/// In the board's frame B; triangles face its viewer. The hole's edge is a polygon of 4 x 48
/// corners, within 0.1 mm of the circle at a radius of 0.17 m.
SurfaceMesh BoardPlate(const BoardView& view);

}  // namespace dockyard
