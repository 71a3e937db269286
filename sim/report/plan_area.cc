#include "sim/report/plan_area.h"

#include <algorithm>
#include <cmath>

namespace dockyard {

PlotArea PlanArea(const std::vector<Pose2>& X_DO) {
  constexpr double kFarthest_m = 20.0, kAround_m = 0.6, kWidth_px = 860.0, kHeight_px = 760.0;
  DataRange x{-1.0, 1.5}, y{-1.0, 1.0};
  const auto near = [&](double at) { return std::clamp(at, -kFarthest_m, kFarthest_m); };
  for (const Pose2& pose : X_DO) {
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y)) continue;
    for (const double around_m : {-kAround_m, kAround_m}) {
      x.Hold(near(pose.x) + around_m);
      y.Hold(near(pose.y) + around_m);
    }
  }
  const double scale = std::min(kWidth_px / x.span(), kHeight_px / y.span());
  return {{78.0, 74.0}, scale * x.span(), scale * y.span(), x, y};
}

bool Inside(const PlotArea& area, double x, double y) {
  return x >= area.x.low && x <= area.x.high && y >= area.y.low && y <= area.y.high;
}

void DrawCross(SvgDocument& svg, Px at, double reach_px, const Pen& pen) {
  svg.Line({at.x - reach_px, at.y - reach_px}, {at.x + reach_px, at.y + reach_px}, pen);
  svg.Line({at.x - reach_px, at.y + reach_px}, {at.x + reach_px, at.y - reach_px}, pen);
}

void DrawPlanAxes(SvgDocument& svg, const PlotArea& area) {
  area.DrawAxes(svg, "out along the target's axis, x [m]", "to the left, y [m]");
  const Pen guide{"#b9c4d0", 1.0, "3 4", 1.0};
  const double farthest =
      std::hypot(std::max(area.x.high, -area.x.low), std::max(area.y.high, -area.y.low));
  for (double r = 1.0; r < farthest; r += 1.0) {
    std::vector<Px> arc;
    for (int deg = -180; deg <= 180; deg += 2) {
      const double x = r * std::cos(Radians(deg)), y = r * std::sin(Radians(deg));
      if (Inside(area, x, y)) {
        arc.push_back(area.At(x, y));
        continue;
      }
      svg.Polyline(arc, guide);
      arc.clear();
    }
    svg.Polyline(arc, guide);
  }
  const Pen target{"#444444", 2.0, "", 1.0};
  svg.OpenGroup("target");
  svg.Line(area.At(0.0, -0.4), area.At(0.0, 0.4), target);
  svg.Line(area.At(0.0, 0.0), area.At(0.5, 0.0), target);
  svg.CloseGroup();
  const Px at = area.At(0.0, 0.0);
  svg.Text({at.x - 6, at.y + 4}, "target", {11, "#444444", Anchor::kEnd});
}

}  // namespace dockyard
