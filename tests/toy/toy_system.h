// The smallest system: a point that drives to a flag on a line. It shows that a system needs no
// line in a generic room.
#pragma once

#include "sim/run/system.h"

namespace dockyard::toy {

System ToySystem();

}  // namespace dockyard::toy
