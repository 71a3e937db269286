// What keeps a robot from the docked pose of its scenario: found by geometry alone, with all joints
// at their starts.
#pragma once

#include "sim/custom/custom_models.h"
#include "sim/custom/findings.h"

namespace dockyard::custom {

/// Robot and dock that overlap where the judge has the robot docked, pins that do not meet their
/// pads there, and a staging pose outside the yard.
Findings FindInDocking(const Scenario& scenario, const CustomModels& models);

/// All findings of the models and of the docking.
Findings FindInScenario(const Scenario& scenario, const CustomModels& models);

}  // namespace dockyard::custom
