// The mapping `imu` of a robot's file.
#pragma once

#include "models/parts/imu.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names its keys.
void VisitImu(Keys& keys, ImuModel& imu);

}  // namespace dockyard
