// The brain named in a scenario.
#pragma once

#include <memory>
#include <string>

#include "controller/io/controller.h"
#include "controller/io/rover_sheet.h"

namespace dockyard {

/// "axel" or "reel_only", as the scenario reader has checked. A fresh controller at each call.
/// Throws ConfigError for any other name, as a foreign log may hold.
std::unique_ptr<Controller> MakeController(const std::string& name, const RoverSheet& sheet);

}  // namespace dockyard
