// The mapping of a tyre in a robot's file -> TyreModel.
#pragma once

#include "models/parts/tyre.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names every key of a tyre. The model's values so far hold for those that are left out.
void VisitTyre(Keys& keys, TyreModel& tyre);

}  // namespace dockyard
