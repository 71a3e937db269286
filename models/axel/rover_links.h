// The rover's links and joints from its URDF.
#pragma once

#include "models/axel/axel_model.h"
#include "models/read/urdf.h"

namespace dockyard::axel {

/// Body, wheels and arm with all links fixed to them, the joints between them, and the arm's
/// limits. Arm length and tip must have been read before. Throws ConfigError with the line for
/// links and joints that are missing, turned otherwise than the rover's model has them, or further
/// than these.
void TakeRoverLinks(const UrdfModel& file, RoverModel& rover);

}  // namespace dockyard::axel
