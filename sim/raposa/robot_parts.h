// Parts of the robot for spectators alone: its docking socket with funnel, doors in their rails,
// camera and lamps. The robot's own camera cannot see them, and they throw no shadow that it sees.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "models/raposa/robot_model.h"
#include "render/scene.h"

namespace dockyard::raposa {

struct RobotPart {
  RenderMesh mesh;                     // in the body's frame R; of a door in the door's
  Eigen::Vector3d rgb{0.5, 0.5, 0.5};  // linear
};

/// Housing with its hole, funnel, bore, rails, camera and lamps.
std::vector<RobotPart> SocketParts(const RobotModel& robot);
/// A door's plate with its V. left: the door at y > 0.
std::vector<RobotPart> DoorParts(const DoorsModel& doors, bool left);

}  // namespace dockyard::raposa
