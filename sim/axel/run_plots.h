// Plots of one run, after Tsai et al., Figs. 10 and 11.
#pragma once

#include <string>
#include <vector>

#include "models/axel/station_model.h"
#include "sim/log/record.h"
#include "sim/report/svg.h"

namespace dockyard::axel {

/// SVG: the true path in the dock frame, the places where images were taken, what vision measured
/// there, and the arcs planned from it (Figs. 10a, 11a).
std::string PathPlot(const RunRecord& record, const ConeModel& cone);

/// SVG over time: roll, pitch and heading against the cone's axis (Figs. 10b, 11b), tether tension,
/// motor currents, depth of the tip; the controller's phases on top.
std::string HistoryPlot(const RunRecord& record);

/// "run 7: soil loose, start.r_m 5: docked after 190 s"
std::string RunTitle(const RunRecord& record);

/// Points along a planned arc in the dock frame, its start and end included.
std::vector<Eigen::Vector2d> ArcPoints(const PlannedArc& arc, int pieces);

}  // namespace dockyard::axel
