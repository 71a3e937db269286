// The systems of this project, with their controllers: the only place that knows both.
#pragma once

#include <vector>

#include "sim/run/system.h"

namespace dockyard {

std::vector<System> Systems();

}  // namespace dockyard
