// RAPOSA as a system.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "controller/raposa/nominal/nominal.h"
#include "sim/run/system.h"

namespace dockyard::raposa {

struct NamedController {
  std::string name;
  std::function<std::unique_ptr<Controller>(const Nominal&)> make;
};

/// The first controller is the default.
System RaposaSystem(const std::vector<NamedController>& controllers,
                    const std::vector<SystemCommand>& commands = {},
                    const CommandFunction& detect = {});

}  // namespace dockyard::raposa
