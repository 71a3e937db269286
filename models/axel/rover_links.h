// The rover's links and joints from its URDF.
#pragma once

#include "models/axel/axel_model.h"
#include "models/read/load_joints.h"
#include "models/read/urdf.h"

namespace dockyard::axel {

/// Body, wheels and arm with all links fixed to them, the joints between them, and the arm's
/// limits. Throws ConfigError with the line for links and joints that are missing or turned
/// otherwise than the rover's model has them.
void TakeRoverLinks(const UrdfModel& file, RoverModel& rover);

/// Numbers of those links among all links of the rover: the order of TakeFurtherLinks.
inline constexpr int kArmNumber = 3;
/// All other links that move. `in`: the rover's file. Throws as TakeJointedLinks.
JointedLinks TakeFurtherLinks(const YamlReader& in, const UrdfModel& file,
                              const JointsFile& joints);

/// The tip's disc is simulated by itself: no other part of the arm may reach past its middle.
/// Throws ConfigError.
void CheckArm(const UrdfModel& file, const RoverModel& rover);

}  // namespace dockyard::axel
