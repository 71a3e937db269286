// Ink that has flaked off a board, in patches.
#pragma once

#include <Eigen/Core>
#include <array>

#include "render/scene.h"

namespace dockyard {

/// Share of a footprint on the board, its corners in their order round it, from which ink has
/// flaked. Patches are cells about points scattered on a grid of 2 mm, 1 to 4 mm wide (assumed);
/// each has flaked with the probability BoardView::wear.
float FlakedShare(const BoardView& board, const std::array<Eigen::Vector2f, 4>& footprint_B);

}  // namespace dockyard
