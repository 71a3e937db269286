// The place of a camera that shows one point of a run from near.
#pragma once

#include <cstddef>

#include "sim/log/logged_run.h"
#include "sim/run/stage_shapes.h"
#include "sim/spectator/aim_point.h"

namespace dockyard {

struct NearView {
  Eigen::Vector3d from_W;  // of the camera
  Eigen::Vector3d at_W;    // the point, mean of the samples at which the robot is at it
  double radius_m = 0.0;   // about the point, what an image at that distance is to hold
};

/// As near as an image with this height shows the point with what is about it, in the direction
/// from which the drawn bodies hide the least of it while the robot is at it, and which
/// the robot never enters. Of equal directions the one nearest to that of SpectatorPose. While the
/// robot is at it: the samples from `first` to `last` at which the robot's parts are as near to the
/// point as ever, to 0.1 m; for a point of the robot, those at which it is as near to the target.
/// The name must be one of AimNames. Throws DataError as AimPlace.
NearView FindNearView(const LoggedRun& run, const StageShapes& shapes, const Aim& aim,
                      std::size_t first, std::size_t last, double vertical_fov_rad);

}  // namespace dockyard
