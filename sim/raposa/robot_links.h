// RAPOSA's robot as a tree: a free body with the arm on a hinge and two doors on slides along y.
#pragma once

#include <vector>

#include "models/raposa/robot_model.h"
#include "sim/rigid/tree_body.h"

namespace dockyard::raposa {

/// Numbers of the tree's links.
enum RobotLink : int { kBody, kArm, kLeftDoor, kRightDoor };
inline constexpr int kRobotLinkCount = 4;

/// The arm's angle is positive with its tip down; a door's place is along y from closed.
std::vector<TreeLink> RobotLinks(const RobotModel& robot);
/// Arm level, doors open.
TreeBody MakeRobot(const RobotModel& robot, const Pose3& X_GR);
/// What a link meets the pyramid with, but for the socket.
std::vector<Collision> PiecesOf(const RobotModel& robot, RobotLink link);

}  // namespace dockyard::raposa
