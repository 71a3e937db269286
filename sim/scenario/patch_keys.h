// The scenario's list `yard.patches`.
#pragma once

#include "sim/scenario/scenario.h"

namespace dockyard {

/// Reads the list into the yard's patches and makes its files absolute. Throws ConfigError.
void ReadPatches(YardModel& yard);

/// Whether a patch holds a point of D.
bool Holds(const YardPatch& patch, const Eigen::Vector2d& p_D);

}  // namespace dockyard
