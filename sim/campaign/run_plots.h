// Plots of one run, after Tsai et al., Figs. 10 and 11.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/campaign/svg.h"
#include "sim/run/record.h"

namespace dockyard {

/// SVG: the true path in the dock frame, the places where images were taken, what vision measured
/// there, and the arcs planned from it (Figs. 10a, 11a).
std::string PathPlot(const RunRecord& record);

/// SVG over time: roll, pitch and heading against the cone's axis (Figs. 10b, 11b), tether tension,
/// motor currents, depth of the tip; the controller's phases on top.
std::string HistoryPlot(const RunRecord& record);

/// "run 7: r 5.0 m, ... docked after 190 s"
std::string RunTitle(const RunResult& row);

/// Points along a planned arc in the dock frame, its start and end included.
std::vector<Eigen::Vector2d> ArcPoints(const PlannedArc& arc, int pieces);

/// Writes path.svg and history.svg into the folder. Throws IoError.
void WriteRunPlots(const std::filesystem::path& dir, const RunRecord& record);

}  // namespace dockyard
