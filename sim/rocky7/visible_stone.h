// What of a stone a camera shows among others.
#pragma once

#include <optional>
#include <vector>

#include "sim/rigid/convex_body.h"
#include "sim/rocky7/world.h"

namespace dockyard::rocky7 {

/// The stones at the start, in G.
struct StonesInView {
  ConvexBody target_G;
  std::vector<ConvexBody> others_G;
};

/// Of a world whose target is a stone.
StonesInView StonesAtStart(const WorldSetup& world, const Truth& truth);

/// Whether the ray meets another stone, and the target not before it.
bool ShowsAnother(const StonesInView& stones, const Eigen::Vector3d& from_G,
                  const Eigen::Vector3d& direction_G);

/// The mean of the target's triangles that face the camera, are above the ground and are hidden by
/// no other stone; none: it is hidden.
std::optional<Eigen::Vector3d> VisibleMiddle(const StonesInView& stones, const HeightGrid& ground_G,
                                             const Eigen::Vector3d& from_G);

}  // namespace dockyard::rocky7
