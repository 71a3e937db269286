// Free places for solids on the ground, in plan.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "sim/base/random.h"
#include "sim/scenario/scenery.h"

namespace dockyard {

/// Of the circle round a solid that is upright.
double RadiusOf(const SceneryItem& solid);
/// Of a point from a line between two others.
double DistanceTo(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
/// Puts a solid on a free place within the radius about the origin, with any turn; false after 200
/// tries.
bool PlaceInDisc(RandomStream& random, double radius_m,
                 const std::function<bool(const Eigen::Vector2d& p)>& is_free, SceneryItem& solid);

}  // namespace dockyard
