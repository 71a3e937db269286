// Shapes of an arm and its scoops, made from a few numbers: for contacts and for drawing.
#pragma once

#include <array>
#include <vector>

#include "models/parts/arm_model.h"
#include "models/parts/mesh.h"

namespace dockyard {

/// Outer profile of the front scoop in x and z of its link, from the hub over the back to the lip;
/// the scoop is at x >= 0 and its mouth at x = 0 [m].
std::array<Eigen::Vector2d, 4> ScoopProfile(const ScoopModel& scoop);

/// The plates of a scoop in its link: floor with the lip first, then back and top; right and left
/// wall where its sides are closed. Each is convex and closed. The back scoop is the front one with
/// x reversed.
std::vector<TriangleMesh> ScoopPlates(const ScoopModel& scoop, bool front);

/// The arm's bar in its link, from shoulder to just beyond the scoops' axis; convex.
TriangleMesh ArmBar(const ArmModel& arm);

}  // namespace dockyard
