// A toy system under water: a vehicle with six degrees of freedom swims into a cage in a current.
// It shows that neither the plane nor the sensors of rovers are built into a generic room.
#pragma once

#include "sim/run/system.h"

namespace dockyard::diver {

System DiverSystem();

}  // namespace dockyard::diver
