// The scenario's list `scenery`.
#pragma once

#include "sim/scenario/scenario.h"

namespace dockyard {

/// Reads the list into the scenario's items and makes its files absolute. Throws ConfigError.
void ReadScenery(Scenario& scenario);

/// By SceneryItem::Colour.
const std::vector<std::string>& SceneryColours();

}  // namespace dockyard
