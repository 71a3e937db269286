// RAPOSA as a system.
#pragma once

#include <vector>

#include "controller/raposa/nominal/nominal.h"
#include "sim/run/system_frame.h"

namespace dockyard::raposa {

/// The first controller is the default.
System RaposaSystem(const std::vector<NamedController<Nominal>>& controllers,
                    const std::vector<SystemCommand>& commands = {},
                    const SystemCommand& detect = {});

}  // namespace dockyard::raposa
