// The docking controller of MakeDockyardController with its options as a parameter, for tests and
// tuning.
#pragma once

#include <memory>

#include "controller/axel/axel.h"
#include "controller/axel/options.h"

namespace dockyard::axel {

/// As MakeDockyardController, with other options. The locator must be callable.
std::unique_ptr<Controller> MakeAxelMachine(const Nominal& nominal, const AxelOptions& options,
                                            Locator locator);

}  // namespace dockyard::axel
