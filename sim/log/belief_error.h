// How far a controller's belief is from the truth, over a run's history.
#pragma once

#include <vector>

#include "sim/log/record.h"

namespace dockyard {

/// Of the believed pose, for every system.
const std::vector<Column>& BeliefErrorColumns();
/// In the order of the columns; NaN while the robot is not located.
std::vector<double> BeliefErrors(const HistorySample& sample);

}  // namespace dockyard
