// The convex pieces that meet when the guide enters the robot: funnel, seat and doors of the robot,
// bi-cone, rod and case of the pyramid. Surfaces are where the models say, the contact solver's
// margin included.
#pragma once

#include <vector>

#include "models/parts/link.h"
#include "models/raposa/pyramid_model.h"
#include "models/raposa/robot_model.h"

namespace dockyard::raposa {

/// Walls of funnel and seat, in R: wedges round the seat's axis.
std::vector<Collision> SocketWalls(const RobotModel& robot);
/// The two pieces of a door's plate above and below its V, in the door's frame. left: the door at
/// y > 0.
std::vector<Collision> DoorPieces(const DoorsModel& doors, bool left);
/// Bi-cone, rod and the blunt faces behind it, in P.
std::vector<Collision> GuidePieces(const PyramidModel& pyramid);

/// The guide's axis in P: z of the turned shapes, from the rod to the tip.
Pose3 GuideAxis(const GuideModel& guide);
/// (z, radius) of the bi-cone about that axis, z = 0 its middle.
std::vector<Eigen::Vector2d> GuideProfile(const GuideModel& guide);

}  // namespace dockyard::raposa
