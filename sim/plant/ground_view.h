// The yard's ground as a part of a scene.
#pragma once

#include "render/scene.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// Borrows the grid's heights: draw it before the grid changes.
inline GroundView ViewOf(const HeightGrid& grid, const Pose3& X_WG, const Eigen::Vector3d& albedo,
                         std::uint64_t texture_seed = 1) {
  return {.X_WG = X_WG,
          .x0_m = grid.x0_m,
          .y0_m = grid.y0_m,
          .cell_m = grid.cell_m,
          .nx = grid.nx,
          .ny = grid.ny,
          .heights_m = grid.heights_m.data(),
          .revision = grid.revision,
          .albedo = albedo,
          .texture_seed = texture_seed};
}

}  // namespace dockyard
