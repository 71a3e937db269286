// How much of its own body the rover has before its cameras.
#pragma once

#include <string>

#include "models/axel/axel_model.h"

namespace dockyard::axel {

/// Share of an image that the drawn body and wheels fill, 0 to 1, by a grid of its rays. The arm,
/// which moves, does not count. `X_RC`: the camera in the body.
double ShareOfOwnBody(const RoverModel& rover, const Camera& camera, const Pose3& X_RC);

/// What is wrong with cameras that have the rover itself before them in more than half of an
/// image, such as those inside a part of it: "90 % of the left image". Empty: nothing.
std::string BlindedBy(const RoverModel& rover);

}  // namespace dockyard::axel
