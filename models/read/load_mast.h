// The mast in a rover's file.
#pragma once

#include "models/parts/mast_model.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names its keys.
void VisitMast(Keys& keys, MastModel& mast);

}  // namespace dockyard
