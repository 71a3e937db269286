// What the mast's cameras show to stand out of the ground before a face: for the rover's path.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/rocky7/face_stereo.h"

namespace dockyard::rocky7 {

/// What stands higher over the ground than wheels and body pass, about a place, in E's plan: the
/// middles of the cells of a raster in which it is seen.
std::vector<Eigen::Vector2d> StandsOut(const FaceView& view, const Eigen::Vector2d& p_E);

}  // namespace dockyard::rocky7
