#include "sim/paths/path_svg.h"

#include <algorithm>
#include <cmath>

#include "controller/motion/polygon.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kLeft_px = 78.0, kTop_px = 84.0, kWidth_px = 820.0, kMostHeight_px = 700.0;
constexpr double kAngles_px = 150.0, kBetween_px = 70.0, kLegend_px = 56.0;
constexpr double kStep_m = 0.04, kStep_rad = 0.08;
const Pen kKept{"#9aa7b5", 1.0, "", 0.9}, kLeftOut{"#d3a29a", 1.0, "3 4", 0.9};
const Pen kPath{"#0b6fb8", 3.0, "", 1.0}, kPointWay{"#1c8a4b", 1.5, "5 3", 1.0};
const Pen kOutline{"#333333", 1.2, "", 1.0}, kThin{"#555555", 1.0, "", 1.0};
const std::vector<std::string> kWheelColours{"#0b6fb8", "#c4511d", "#1c8a4b",
                                             "#8a3fa0", "#b08900", "#5a5a5a"};

std::vector<Px> OnPage(const PlotArea& area, const std::vector<Vector2d>& points) {
  std::vector<Px> page;
  for (const Vector2d& p : points) page.push_back(area.At(p.x(), p.y()));
  return page;
}

// Of a point of the rover along a path.
std::vector<Vector2d> WayOf(const std::vector<Arc>& arcs, const Vector2d& p_RP) {
  std::vector<Vector2d> way;
  for (const Pose2& X_AR : PosesAlong(arcs, kStep_m, kStep_rad)) way.push_back(X_AR * p_RP);
  return way;
}

// Places where a rover is drawn: where arcs begin and end.
std::vector<Pose2> Stations(const std::vector<Arc>& arcs) {
  std::vector<Pose2> stations{{}};
  for (const Arc& arc : arcs) stations.push_back(Advance(stations.back(), arc));
  return stations;
}

PlotArea AreaOf(const PathTask& task, const PlannedPath& plan) {
  constexpr double kAround_m = 0.25;
  DataRange x = DataRange::Nothing(), y = DataRange::Nothing();
  const auto Hold = [&](const Vector2d& p) {
    for (const double around_m : {-kAround_m, kAround_m}) {
      x.Hold(p.x() + around_m);
      y.Hold(p.y() + around_m);
    }
  };
  Hold({0, 0});
  Hold(task.p_RP);
  Hold(task.p_AG);
  if (task.demands.p_AT) Hold(*task.demands.p_AT);
  if (plan.best) {
    for (const Vector2d& p : WayOf(plan.best->arcs, {0, 0})) Hold(p);
    for (const Pose2& X_AR : Stations(plan.best->arcs)) {
      for (const Polygon& part : OutlineOn(task.rover, {1.0, 0.0})) {
        for (const Vector2d& corner : part) Hold(X_AR * corner);
      }
    }
  }
  // Some way beyond the path, so that candidates beside it are seen.
  const double beside_m = 0.12 * std::hypot(x.span(), y.span());
  y.Hold(y.low - beside_m * (y.span() < x.span()));
  y.Hold(y.high + beside_m * (y.span() < x.span()));
  const double scale = std::min(kWidth_px / x.span(), kMostHeight_px / y.span());
  return {{kLeft_px, kTop_px}, scale * x.span(), scale * y.span(), x, y};
}

// The parts of a line that lie within the area.
void DrawWithin(SvgDocument& svg, const PlotArea& area, const std::vector<Vector2d>& points,
                const Pen& pen) {
  std::vector<Px> piece;
  const auto Put = [&] {
    if (piece.size() > 1) svg.Polyline(piece, pen);
    piece.clear();
  };
  for (const Vector2d& p : points) {
    if (p.x() < area.x.low || p.x() > area.x.high || p.y() < area.y.low || p.y() > area.y.high) {
      Put();
    } else {
      piece.push_back(area.At(p.x(), p.y()));
    }
  }
  Put();
}

bool IsOutside(const PlotArea& area, const Disc& disc) {
  const Vector2d& p = disc.centre;
  return p.x() + disc.radius_m < area.x.low || p.x() - disc.radius_m > area.x.high ||
         p.y() + disc.radius_m < area.y.low || p.y() - disc.radius_m > area.y.high;
}

void DrawObstacles(SvgDocument& svg, const PlotArea& area, const Obstacles& obstacles) {
  svg.OpenGroup("obstacles");
  for (const Disc& disc : obstacles.discs) {
    if (IsOutside(area, disc)) continue;
    const double radius_px = disc.radius_m * area.width / area.x.span();
    svg.Circle(area.At(disc.centre.x(), disc.centre.y()), radius_px, "#c9b8a3", kThin);
  }
  for (const Polygon& polygon : obstacles.polygons) {
    svg.Polygon(OnPage(area, polygon), "#c9b8a3", kThin);
  }
  svg.CloseGroup();
}

void DrawRover(SvgDocument& svg, const PlotArea& area, const PathTask& task, const Pose2& X_AR,
               const Arc& arc) {
  std::size_t part = 0;
  for (const Polygon& outline : OutlineOn(task.rover, arc)) {
    const bool is_wheel = part++ >= task.rover.body.size();
    svg.Polygon(OnPage(area, Moved(X_AR, outline)), is_wheel ? "#777777" : "none", kOutline);
  }
  const Vector2d nose = X_AR * Vector2d(0.12, 0.0);
  svg.Line(area.At(X_AR.x, X_AR.y), area.At(nose.x(), nose.y()), kOutline);
}

void DrawMarks(SvgDocument& svg, const PlotArea& area, const PathTask& task) {
  svg.Circle(area.At(task.p_RP.x(), task.p_RP.y()), 4.0, "#ffffff", kOutline);
  svg.Circle(area.At(task.p_AG.x(), task.p_AG.y()), 4.0, "#1c8a4b", kOutline);
  if (task.demands.p_AT) {
    const Px at = area.At(task.demands.p_AT->x(), task.demands.p_AT->y());
    svg.Circle(at, 5.0, "#c4511d", kOutline);
    svg.Text({at.x + 8, at.y - 6}, "target", {11});
  }
}

// Steering angles over the way: constant along each arc.
void DrawAngles(SvgDocument& svg, const PathTask& task, const PlannedPath& plan, Px corner) {
  double least = 0.0, most = 0.0;
  for (const WheelPlan& wheel : task.rover.wheels) {
    for (const Arc& arc : plan.best->arcs) {
      least = std::min(least, Degrees(OnArc(wheel, arc).steer_rad));
      most = std::max(most, Degrees(OnArc(wheel, arc).steer_rad));
    }
  }
  const double length_m = std::max(Length(plan.best->arcs), 1e-3);
  const PlotArea area{corner, kWidth_px, kAngles_px, {0.0, length_m}, {least - 5.0, most + 5.0}};
  area.DrawAxes(svg, "way of the reference point [m]", "steering [deg]");
  std::vector<std::pair<std::string, Pen>> legend;
  for (const WheelPlan& wheel : task.rover.wheels) {
    if (wheel.steer_limit_rad == 0.0) continue;
    const Pen pen{kWheelColours[legend.size() % kWheelColours.size()], 2.0, "", 1.0};
    std::vector<Px> line;
    double way_m = 0.0;
    for (const Arc& arc : plan.best->arcs) {
      const double deg = Degrees(OnArc(wheel, arc).steer_rad);
      line.push_back(area.At(way_m, deg));
      way_m += std::abs(arc.length_m);
      line.push_back(area.At(way_m, deg));
    }
    svg.Polyline(line, pen);
    legend.emplace_back(wheel.name, pen);
  }
  DrawLegend(svg, {corner.x, corner.y + kAngles_px + kLegend_px}, legend);
}

bool HasSteeredWheels(const RoverPlan& rover) {
  return std::any_of(rover.wheels.begin(), rover.wheels.end(),
                     [](const WheelPlan& wheel) { return wheel.steer_limit_rad != 0.0; });
}

}  // namespace

std::string PathSvg(const PathTask& task, const PlannedPath& plan) {
  const PlotArea area = AreaOf(task, plan);
  const bool angles = plan.best && !plan.best->arcs.empty() && HasSteeredWheels(task.rover);
  const double bottom_px = kTop_px + area.height + kBetween_px;
  SvgDocument svg(kLeft_px + kWidth_px + 30.0,
                  angles ? bottom_px + kAngles_px + kLegend_px + 24.0 : bottom_px,
                  "A planned path");
  svg.Text({kLeft_px, 24}, Words(plan), {15, "#222222", Anchor::kStart, true});
  DrawLegend(svg, {kLeft_px, 48},
             {{"path of R", kPath},
              {"of the point", kPointWay},
              {"candidate", kKept},
              {"beyond a limit or blocked", kLeftOut}});
  area.DrawAxes(svg, "ahead, x [m]", "to the left, y [m]");
  DrawObstacles(svg, area, task.demands.obstacles);
  svg.OpenGroup("candidates");
  for (const bool usable : {false, true}) {
    for (const Candidate& candidate : plan.candidates) {
      if (candidate.IsUsable() != usable) continue;
      DrawWithin(svg, area, WayOf(candidate.arcs, {0, 0}), usable ? kKept : kLeftOut);
    }
  }
  svg.CloseGroup();
  if (plan.best) {
    const std::vector<Arc>& arcs = plan.best->arcs;
    svg.OpenGroup("path");
    const std::vector<Pose2> stations = Stations(arcs);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Arc on = arcs.empty() ? Arc{1.0, 0.0} : arcs[std::min(i, arcs.size() - 1)];
      DrawRover(svg, area, task, stations[i], on);
    }
    DrawWithin(svg, area, WayOf(arcs, task.p_RP), kPointWay);
    DrawWithin(svg, area, WayOf(arcs, {0, 0}), kPath);
    svg.CloseGroup();
  } else {
    DrawRover(svg, area, task, {}, {1.0, 0.0});
  }
  DrawMarks(svg, area, task);
  if (angles) DrawAngles(svg, task, plan, {kLeft_px, bottom_px});
  return svg.Finish();
}

}  // namespace dockyard
