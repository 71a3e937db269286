// Rocky 7's cameras and its control period. Its motors: the wheels' drives in the order of its
// plan, then the steering of those wheels that steer, in the same order.
#pragma once

#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

/// The front body pair.
inline constexpr int kFrontLeft = 0, kFrontRight = 1, kCameraCount = 2;

/// Assumed, 20-100 ms: the rover's computer gives its drives positions and reads them.
inline constexpr Tick kControlPeriod = 50;

}  // namespace dockyard::rocky7
