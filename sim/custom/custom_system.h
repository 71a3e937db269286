// The system of robots and docks that are described by files.
#pragma once

#include <string>
#include <vector>

#include "controller/custom/nominal/nominal.h"
#include "sim/run/system_frame.h"

namespace dockyard::custom {

/// Throws ConfigError: a controller that cannot work with a robot and a dock, and why.
[[noreturn]] void RefuseController(const std::string& controller, const std::string& reason);

/// The first controller is the default one.
System CustomSystem(const std::vector<NamedController<Nominal>>& controllers);

}  // namespace dockyard::custom
