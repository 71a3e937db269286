// What meets when the guide enters the robot: funnel, seat and doors of the robot, bi-cone, rod and
// case of the pyramid. Surfaces are where the models say, the contact solver's margin included.
#pragma once

#include <vector>

#include "models/parts/link.h"
#include "models/raposa/pyramid_model.h"
#include "models/raposa/robot_model.h"
#include "sim/rigid/bore_contacts.h"

namespace dockyard::raposa {

/// The frame in R of the socket's walls: z inwards along its axis, from where the guide's middle is
/// once docked.
Pose3 SocketAxis(const SocketModel& socket);
/// Where the pyramid, all of it, meets the walls of funnel and seat.
BoreContacts SocketContacts(const RobotModel& robot, const PyramidModel& pyramid);
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
