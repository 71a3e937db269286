// The built pyramid in a sharp image without a light, by a plain depth buffer: what the camera
// would see of it without lens and sensor. Nothing of render/'s drawing is in it.
#pragma once

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "controller/geometry/pose.h"
#include "models/raposa/pyramid_model.h"

namespace dockyard::raposa {

/// Orange, blue and grey parts before a black background.
/// @param X_PC  the camera's pose in P: z along its view, x right, y down
RgbImage DrawnPyramid(const PyramidModel& pyramid, const Camera& camera, const Pose3& X_PC);

}  // namespace dockyard::raposa
