// An arm with scoops, from a mapping of a rover's file.
#pragma once

#include "models/parts/arm_model.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names its keys.
void VisitArm(Keys& keys, ArmModel& arm);

}  // namespace dockyard
