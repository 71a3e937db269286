// Parts of the twin's MJCF beside the rover's links: an uneven ground, the cone and the arm in it.
#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "sim/soil/height_grid.h"

namespace dockyard::axel {

/// A MuJoCo height field of the same samples; TakeHeights fills it once the model is made.
std::string HeightFieldAsset(const HeightGrid& grid);
std::string HeightFieldGeom(const HeightGrid& grid);
void TakeHeights(const HeightGrid& grid, mjModel& model);

/// Funnel and socket cut into 24 sectors, each a convex hull, and the floor as one more, on a body
/// that stands fast. X_GM: the mouth.
std::string ConeMeshes(const ConeModel& cone);
std::string ConeBody(const ConeModel& cone, const Pose3& X_GM);
/// The arm's shapes; turned ones as hulls of 24 corners a rim.
std::string ArmMeshes(const RoverModel& rover);
std::string ArmGeoms(const RoverModel& rover);

}  // namespace dockyard::axel
