// The Rocky 7 system: a rover drives to a stone that a user has clicked on.
#pragma once

#include <vector>

#include "controller/rocky7/nominal/nominal.h"
#include "sim/run/system_frame.h"

namespace dockyard::rocky7 {

/// The first controller is the default one.
System Rocky7System(const std::vector<NamedController<Nominal>>& controllers);

}  // namespace dockyard::rocky7
