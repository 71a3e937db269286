// How far collision shapes reach.
#pragma once

#include "models/parts/link.h"

namespace dockyard {

/// The largest x of the shape in its link's frame [m].
double ReachAlongX(const Collision& collision);

}  // namespace dockyard
