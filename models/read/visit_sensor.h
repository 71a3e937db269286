// The keys of a camera's sensor and of its lens's errors, which pairs and single cameras share.
#pragma once

#include "models/parts/camera_sensor.h"
#include "models/read/keys.h"

namespace dockyard {

/// `needed`: of the keys that a pair's file must have.
void VisitSensor(Keys& keys, SensorModel& sensor, Presence needed);
void VisitLensErrors(Keys& keys, LensErrors& errors, Presence needed);

}  // namespace dockyard
