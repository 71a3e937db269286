// The docking machine of MakeAxelController, with its options open: for tests and tuning.
#pragma once

#include <memory>

#include "controller/docking/axel.h"
#include "controller/docking/options.h"

namespace dockyard {

/// As MakeAxelController, with other options. The locator must be callable.
std::unique_ptr<Controller> MakeAxelMachine(const RoverSheet& sheet, const AxelOptions& options,
                                            Locator locator);

}  // namespace dockyard
