// Swims onto the cage's axis, then in, by dead reckoning that acoustic fixes correct.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "sim/base/json.h"

namespace dockyard::diver {

inline constexpr Tick kPeriod = 20;
inline constexpr double kRadPerCount = 1e-2;
inline constexpr double kCageDepth_m = 12.0;  // of the cage's axis below the surface

std::unique_ptr<Controller> MakeSwimIn(const Json& nominal);

}  // namespace dockyard::diver
