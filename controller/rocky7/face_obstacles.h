// Obstacles before a face, as the mast's cameras show them: for the rover's path.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/rocky7/face_stereo.h"

namespace dockyard::rocky7 {

/// Obstacles about a target in E, in plan: the middles of the cells of a raster that are higher
/// over the ground than wheels and body pass, and connected with the target along the surface. A
/// patch of wrong ranges at another height is none. The ground is the plane that the same image
/// shows.
std::vector<Eigen::Vector2d> ObstaclesAbout(const FaceView& view, const Eigen::Vector3d& p_E);

}  // namespace dockyard::rocky7
