// What every controller does with its commands at the end of a step.
#pragma once

#include <span>

#include "controller/io/commands.h"
#include "controller/io/nominal_motor.h"

namespace dockyard {

/// Brings each motor's speed, acceleration and current within its nominal limits. All numbers must
/// be finite.
void KeepLimits(std::span<const NominalMotor> motors, Commands* commands);

}  // namespace dockyard
