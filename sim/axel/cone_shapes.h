// The docking cone as convex wedges, and the arm that enters it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"

namespace dockyard::axel {

/// Corners of the cone's wedges in the mouth frame M. Each wedge is one convex sector of face,
/// funnel and socket: the material outside funnel and socket is convex in every axial cut, so no
/// inner edge lies across the arm's way. Wedges reach a little under their neighbours for the same
/// reason. Corners are placed so that the polygon's mean radius is the model's.
std::vector<std::vector<Eigen::Vector3d>> ConeWedges(const ConeModel& cone);

/// The plate that seats the tip, in the mouth frame M; its front is at stop_depth_m (> 0).
Collision SocketStop(const ConeModel& cone);

/// The arm's shapes: the flat-nosed tip cylinder of ArmTipModel, the collar of CollarModel, and the
/// collisions of the arm's link except those of the same tip and collar.
std::vector<Collision> ArmCollisions(const RoverModel& rover);

}  // namespace dockyard::axel
