// The truth about an image pair: whether it can show the target, and where all is in the
// controller's plan.
#pragma once

#include "controller/io/belief.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/rocky7/target_loss.h"

namespace dockyard::rocky7 {

/// Whether the segment from `from` to `to` meets a part of the mesh that has the pose X_WM, further
/// than the renderer's near plane from `from`.
bool Blocks(const RenderMesh& mesh, const Pose3& X_WM, const Eigen::Vector3d& from_W,
            const Eigen::Vector3d& to_W);

/// Whether the left camera of the task's pair has a place of the world on its image, with no part
/// of the rover before it. Stones and ground are not asked.
bool LeftImageShows(const Rocky7Plant& plant, const Eigen::Vector3d& p_W);

/// The target: a stone's middle, or the point that was clicked on.
Eigen::Vector3d TargetInWorld(const Rocky7Plant& plant);

/// Half of the search window's side is that of the scenario's `nesnas`, for every controller.
/// @param predicted_G  where the controller had the target before this image pair, in the site's
///   plan; none: nowhere yet
LossTruth TruthAt(const Rocky7Plant& plant, const SightingReport& report,
                  const std::optional<Eigen::Vector2d>& predicted_G);

}  // namespace dockyard::rocky7
