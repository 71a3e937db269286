#include "sim/axel/station_outline.h"

#include <algorithm>

namespace dockyard::axel {
namespace {

// The module's box in models/axel/station/station.urdf, from above. Only drawn.
constexpr double kModuleFront_m = -0.005, kModuleBack_m = -0.8, kModuleHalfWidth_m = 0.475;

}  // namespace

void DrawStation(SvgDocument& svg, const PlotArea& area, const ConeModel& cone) {
  const Pen outline{"#444444", 1.2, "", 1.0};
  const double back = std::max(area.x.low, kModuleBack_m);
  svg.Polygon({area.At(back, kModuleHalfWidth_m), area.At(kModuleFront_m, kModuleHalfWidth_m),
               area.At(kModuleFront_m, -kModuleHalfWidth_m), area.At(back, -kModuleHalfWidth_m)},
              "#d5d5d5", outline);
  const double mouth = cone.mouth_radius_m, throat = cone.throat_radius_m;
  const double funnel = -cone.funnel_length_m, end = -cone.socket_end_m;
  svg.OpenGroup("cone");
  svg.Polygon({area.At(0, mouth), area.At(funnel, throat), area.At(end, throat),
               area.At(end, -throat), area.At(funnel, -throat), area.At(0, -mouth)},
              "#ffffff", outline);
  if (cone.stop_depth_m > 0.0) {
    svg.Line(area.At(-cone.stop_depth_m, throat), area.At(-cone.stop_depth_m, -throat), outline);
  }
  svg.CloseGroup();
}

}  // namespace dockyard::axel
