// What plots from above share: the target's frame D on the page.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "sim/report/svg.h"

namespace dockyard {

/// Holds the target and all poses, some way round them; equal scales. Poses farther than 20 m count
/// as 20 m: a wild one must not shrink the rest to a dot.
PlotArea PlanArea(const std::vector<Pose2>& X_DO);
/// Axes, rings of equal distance, and the target as the end of its axis.
void DrawPlanAxes(SvgDocument& svg, const PlotArea& area);
bool Inside(const PlotArea& area, double x, double y);
void DrawCross(SvgDocument& svg, Px at, double reach_px, const Pen& pen);

}  // namespace dockyard
