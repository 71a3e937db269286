// The systems of this project, with their controllers: the one place where both sides meet.
#pragma once

#include <vector>

#include "sim/run/system.h"

namespace dockyard {

std::vector<System> Systems();

}  // namespace dockyard
