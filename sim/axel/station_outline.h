// The station from above, for plots in the dock's frame D.
#pragma once

#include "models/axel/station_model.h"
#include "sim/report/svg.h"

namespace dockyard::axel {

/// The module as a box to 0.8 m behind the mouth's plane, or to the area's edge, and in it the
/// section through the cone's axis: mouth, funnel, socket to its end, and its floor if it has one.
/// The outline of the cone is a group of class "cone".
void DrawStation(SvgDocument& svg, const PlotArea& area, const ConeModel& cone);

}  // namespace dockyard::axel
