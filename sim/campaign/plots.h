// The plot of a whole grid of runs, after Tsai et al., Fig. 9.
#pragma once

#include <string>
#include <vector>

#include "models/station_model.h"
#include "sim/run/record.h"

namespace dockyard {

/// SVG: the dock at the origin, an arrow at each start position in the direction of its heading,
/// blue docked and red not, named by its cause. `cone` is drawn at the dock. The marker at an
/// arrow's tail stands for the soil's label; markers go by the order in which labels first appear,
/// and the key names them (groups of class "soil-key"). Each arrow is a group of class "run-arrow"
/// with id "run-<number>".
std::string GridPlot(const std::string& title, const std::vector<RunResult>& rows,
                     const ConeModel& cone);

}  // namespace dockyard
