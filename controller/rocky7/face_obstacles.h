// Obstacles before a face, as the mast's cameras show them: for the rover's path.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/rocky7/face_stereo.h"

namespace dockyard::rocky7 {

/// Obstacles about a place of E, in plan: the middles of the cells of a raster that are higher over
/// the ground than wheels and body pass. The ground is the plane that the same image shows.
std::vector<Eigen::Vector2d> ObstaclesAbout(const FaceView& view, const Eigen::Vector2d& p_E);

}  // namespace dockyard::rocky7
