// The plot of a whole grid of runs, after Tsai et al., Fig. 9.
#pragma once

#include <string>
#include <vector>

#include "models/axel/station_model.h"
#include "sim/log/record.h"

namespace dockyard::axel {

/// SVG: the dock at the origin, an arrow at each start position in the direction of its heading,
/// blue when docked, red with the cause when not. The marker at the tail shows the label "soil":
/// filled and hollow discs, then triangles, squares, ... by order of appearance; the key names
/// them. Each arrow is a group of class "run-arrow" with id "run-<number>". The labels start.r_m,
/// start.alpha_deg and start.heading_deg must be there.
std::string GridPlot(const std::string& title, const RowColumns& columns,
                     const std::vector<RunResult>& rows, const ConeModel& cone);
/// Whether these three labels are there.
bool HasStartPoses(const RowColumns& columns);

}  // namespace dockyard::axel
