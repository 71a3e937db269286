// Axel as a system: two-wheel tethered rover, docking station, yard (Tsai, Nesnas and Zarzhitsky,
// Autonomous Vision-based Tethered-assisted Rover Docking, 2013).
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/nominal/script.h"
#include "controller/io/controller.h"
#include "sim/run/system_frame.h"

namespace dockyard::axel {

using ScriptPlayer =
    std::function<std::unique_ptr<Controller>(const Nominal&, const std::vector<ScriptStep>&)>;

/// The first controller is the default.
System AxelSystem(const std::vector<NamedController<Nominal>>& controllers,
                  const ScriptPlayer& play);

}  // namespace dockyard::axel
