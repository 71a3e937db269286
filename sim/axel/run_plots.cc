#include "sim/axel/run_plots.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "sim/axel/station_outline.h"
#include "sim/base/text.h"

namespace dockyard::axel {
namespace {

const Pen kTruth{"#222222", 2.0, "", 1.0};
const Pen kPlan{"#2a8f5c", 1.6, "6 3", 0.9};
const Pen kVision{"#e07b00", 1.6, "", 1.0};
const Pen kRefused{"#c8321e", 1.4, "", 1.0};
constexpr const char* kImageFill = "#1f5fbf";

// Drops points nearer than a third of a pixel to the last one: the difference is not visible.
void AddThinned(std::vector<Px>& line, Px point) {
  constexpr double kNearPx = 0.33;
  if (!std::isfinite(point.x) || !std::isfinite(point.y)) return;
  if (!line.empty() && std::hypot(point.x - line.back().x, point.y - line.back().y) < kNearPx) {
    return;
  }
  line.push_back(point);
}

PlotArea PathArea(const RunRecord& record) {
  DataRange x{-0.6, 1.5}, y{-0.9, 0.9};
  const auto hold = [&](double px, double py) {
    x.Hold(px + 0.4);
    y.Hold(py + 0.4);
    y.Hold(py - 0.4);
  };
  for (const HistorySample& sample : record.history) hold(sample.X_DR.x, sample.X_DR.y);
  for (const SightingSample& sample : record.sightings) {
    if (sample.report.accepted) hold(sample.X_DR_measured.x, sample.X_DR_measured.y);
  }
  for (const PlanSample& plan : record.plans) {
    for (const PlannedArc& arc : plan.arcs) {
      for (const Eigen::Vector2d& p : ArcPoints(arc, 8)) hold(p.x(), p.y());
    }
  }
  // A wild estimate must not shrink the rest of the plot to a dot.
  x = {std::max(x.low, -3.0), std::min(x.high, 15.0)};
  y = {std::max(y.low, -8.0), std::min(y.high, 8.0)};
  const double scale = std::min(860.0 / x.span(), 760.0 / y.span());
  return {{78.0, 74.0}, scale * x.span(), scale * y.span(), x, y};
}

bool Inside(const PlotArea& area, double x, double y) {
  return x >= area.x.low && x <= area.x.high && y >= area.y.low && y <= area.y.high;
}

void DrawPlans(SvgDocument& svg, const PlotArea& area, const std::vector<PlanSample>& plans) {
  for (const PlanSample& plan : plans) {
    for (const PlannedArc& arc : plan.arcs) {
      std::vector<Px> line;
      for (const Eigen::Vector2d& p : ArcPoints(arc, 24)) {
        if (Inside(area, p.x(), p.y())) line.push_back(area.At(p.x(), p.y()));
      }
      svg.Polyline(line, kPlan);
      if (!line.empty()) svg.Circle(line.back(), 2.5, kPlan.color, {kPlan.color, 1.0, "", 1.0});
    }
  }
}

void DrawCross(SvgDocument& svg, Px at) {
  svg.Line({at.x - 4, at.y - 4}, {at.x + 4, at.y + 4}, kVision);
  svg.Line({at.x - 4, at.y + 4}, {at.x + 4, at.y - 4}, kVision);
}

void DrawTriangle(SvgDocument& svg, Px at, const std::string& fill, const Pen& pen) {
  svg.Polygon({{at.x, at.y - 6}, {at.x + 5, at.y + 4}, {at.x - 5, at.y + 4}}, fill, pen);
}

void DrawSightings(SvgDocument& svg, const PlotArea& area,
                   const std::vector<SightingSample>& sightings) {
  for (const SightingSample& sample : sightings) {
    const Px true_place = area.At(sample.X_DR.x, sample.X_DR.y);
    const Pose2& seen = sample.X_DR_measured;
    if (!sample.report.accepted) {
      DrawTriangle(svg, true_place, "#ffffff", kRefused);
      continue;
    }
    DrawTriangle(svg, true_place, kImageFill, {kImageFill, 1.0, "", 1.0});
    if (!Inside(area, seen.x, seen.y)) continue;
    const Px measured = area.At(seen.x, seen.y);
    svg.Line(true_place, measured, {kVision.color, 0.8, "", 0.8});
    svg.Line(measured,
             {measured.x + 16 * std::cos(seen.heading), measured.y - 16 * std::sin(seen.heading)},
             {kVision.color, 1.2, "", 1.0});
    DrawCross(svg, measured);
  }
}

void DrawPathKey(SvgDocument& svg, Px at) {
  DrawLegend(svg, at,
             {{"true path", kTruth}, {"planned arcs", kPlan}, {"vision estimate", kVision}});
  at.x += 350;
  DrawTriangle(svg, {at.x, at.y - 4}, kImageFill, {kImageFill, 1.0, "", 1.0});
  svg.Text({at.x + 10, at.y}, "images taken", {11, "#333333"});
  DrawTriangle(svg, {at.x + 100, at.y - 4}, "#ffffff", kRefused);
  svg.Text({at.x + 110, at.y}, "board not located", {11, "#333333"});
}

}  // namespace

std::string RunTitle(const RunRecord& record) {
  const RunResult& row = record.result;
  std::string title = "run " + std::to_string(row.run) + ":";
  for (std::size_t i = 0; i < row.labels.size(); ++i) {
    title += " " + record.columns.labels[i] + " " + row.labels[i] + ",";
  }
  return title + " " + row.outcome + " after " + Fixed(row.sim_time_s, 0) + " s";
}

std::vector<Eigen::Vector2d> ArcPoints(const PlannedArc& arc, int pieces) {
  std::vector<Eigen::Vector2d> points;
  const Pose2& start = arc.X_DR_start;
  for (int i = 0; i <= pieces; ++i) {
    const double turn = arc.turn_rad * i / pieces, length = arc.length_m * i / pieces;
    // Chord of the arc: length sin(turn/2)/(turn/2), in the mean direction.
    const double half = 0.5 * turn;
    const double chord = std::abs(half) < 1e-9 ? length : length * std::sin(half) / half;
    points.emplace_back(start.x + chord * std::cos(start.heading + half),
                        start.y + chord * std::sin(start.heading + half));
  }
  return points;
}

std::string PathPlot(const RunRecord& record, const ConeModel& cone) {
  const PlotArea area = PathArea(record);
  const std::string title = RunTitle(record);
  SvgDocument svg(std::max(area.width + 110.0, 740.0), area.height + 134.0, title);
  svg.Text({area.corner.x, 30}, title, {14, "#111111", Anchor::kStart, true});
  DrawPathKey(svg, {area.corner.x, 56});
  area.DrawAxes(svg, "out along the cone's axis, x [m]", "to the left, y [m]");
  DrawStation(svg, area, cone);
  DrawPlans(svg, area, record.plans);
  std::vector<Px> path;
  for (const HistorySample& sample : record.history) {
    AddThinned(path, area.At(sample.X_DR.x, sample.X_DR.y));
  }
  svg.Polyline(path, kTruth);
  if (!path.empty()) svg.Circle(path.front(), 5.0, "#ffffff", kTruth);
  DrawSightings(svg, area, record.sightings);
  return svg.Finish();
}

}  // namespace dockyard::axel
