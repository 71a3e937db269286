// Bodies that stand on shapes in plan.
#pragma once

#include <memory>

#include "controller/geometry/plan_shapes.h"
#include "render/scene.h"

namespace dockyard {

/// Upright walls over the area's sides from low_m to high_m, with lids that fan out from the mean
/// of its corners: exact where that sees all of them.
std::shared_ptr<const RenderMesh> PrismMesh(const Polygon& area, double low_m, double high_m);

/// A polygon of so many corners on the circle.
Polygon Round(const Disc& disc, int corners);

}  // namespace dockyard
