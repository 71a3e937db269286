// Axel as a system: two-wheel tethered rover, docking station, yard (Tsai, Nesnas and Zarzhitsky,
// Autonomous Vision-based Tethered-assisted Rover Docking, 2013).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/nominal/script.h"
#include "controller/io/controller.h"
#include "sim/run/system.h"

namespace dockyard::axel {

/// A controller of Axel, by the name that scenarios give it.
struct NamedController {
  std::string name;
  std::function<std::unique_ptr<Controller>(const Nominal&)> make;
  std::string former_name{};  // that scenarios of earlier versions give it; empty: none
};
using ScriptPlayer =
    std::function<std::unique_ptr<Controller>(const Nominal&, const std::vector<ScriptStep>&)>;

/// The first controller is the default.
System AxelSystem(const std::vector<NamedController>& controllers, const ScriptPlayer& play);

}  // namespace dockyard::axel
