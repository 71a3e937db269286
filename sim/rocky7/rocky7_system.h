// The Rocky 7 system: a rover drives to a stone that a user has clicked on.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "controller/rocky7/nominal/nominal.h"
#include "sim/run/system.h"

namespace dockyard::rocky7 {

struct NamedController {
  std::string name;
  std::function<std::unique_ptr<Controller>(const Nominal&)> make;
};

/// The first controller is the default one.
System Rocky7System(const std::vector<NamedController>& controllers);

}  // namespace dockyard::rocky7
