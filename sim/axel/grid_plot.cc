#include "sim/axel/grid_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"
#include "sim/axel/station_outline.h"
#include "sim/base/text.h"
#include "sim/report/rate_text.h"
#include "sim/report/svg.h"

namespace dockyard::axel {
namespace {

constexpr const char* kBlue = "#1f5fbf";
constexpr const char* kRed = "#c8321e";
constexpr double kScale = 112.0;   // [px/m]
constexpr double kArrowPx = 46.0;  // tail to point
constexpr double kLetterPx = 6.0;  // mean advance at size 10
constexpr double kSmallText = 10.0;

struct Box {
  double left, top, right, bottom;
  bool Overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

struct Arrow {
  const RunResult* row;
  Px tail, point;
  Px direction;  // unit, on the page
  std::string color;
};

Px Along(const Arrow& arrow, double forward, double right) {
  return {arrow.tail.x + forward * arrow.direction.x - right * arrow.direction.y,
          arrow.tail.y + forward * arrow.direction.y + right * arrow.direction.x};
}

/// The indices of the labels that the plot shows.
struct LabelIndex {
  std::size_t r, alpha, heading;
  std::optional<std::size_t> soil;
};

std::optional<std::size_t> IndexOf(const RowColumns& columns, const char* label) {
  const auto found = std::find(columns.labels.begin(), columns.labels.end(), label);
  if (found == columns.labels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.labels.begin());
}

std::optional<LabelIndex> LabelsOf(const RowColumns& columns) {
  const auto r = IndexOf(columns, "start.r_m"), alpha = IndexOf(columns, "start.alpha_deg");
  const auto heading = IndexOf(columns, "start.heading_deg");
  if (!r || !alpha || !heading) return std::nullopt;
  return LabelIndex{*r, *alpha, *heading, IndexOf(columns, "soil")};
}

Pose2 StartOf(const RunResult& row, const LabelIndex& at) {
  const auto number = [&](std::size_t label) {
    return NumberFromText(row.labels[label]).value_or(0.0);
  };
  return FromDockingCoords({number(at.r), Radians(number(at.alpha)), Radians(number(at.heading))});
}

/// The marker at an arrow's tail by soil: the soil's place in the order in which soils first
/// appear.
std::map<std::string, int> MarkersOf(const std::vector<RunResult>& rows, const LabelIndex& at) {
  std::map<std::string, int> markers;
  if (!at.soil) return markers;
  for (const RunResult& row : rows) {
    markers.emplace(row.labels[*at.soil], static_cast<int>(markers.size()));
  }
  return markers;
}

PlotArea GridArea(const std::vector<RunResult>& rows, const LabelIndex& at) {
  DataRange x{-1.0, 3.0}, y{-1.5, 1.5};
  for (const RunResult& row : rows) {
    const Pose2 start = StartOf(row, at);
    x.Hold(start.x + 0.9);
    y.Hold(start.y + 0.6);
    y.Hold(start.y - 0.6);
  }
  return {{78.0, 74.0}, kScale * x.span(), kScale * y.span(), x, y};
}

std::vector<Arrow> Arrows(const std::vector<RunResult>& rows, const LabelIndex& at,
                          const PlotArea& area) {
  std::vector<Arrow> arrows;
  for (const RunResult& row : rows) {
    const Pose2 X_DR = StartOf(row, at);
    Arrow arrow{&row, area.At(X_DR.x, X_DR.y), {}, {}, row.docked ? kBlue : kRed};
    arrow.direction = {std::cos(X_DR.heading), -std::sin(X_DR.heading)};
    arrow.point = Along(arrow, kArrowPx, 0.0);
    arrows.push_back(arrow);
  }
  return arrows;
}

/// Filled and hollow by turns: first circles, then polygons of 3, 4, 5 ... corners.
void DrawMarker(SvgDocument& svg, Px centre, int marker, const std::string& color) {
  const Pen pen{color, 1.6, "", 1.0};
  const std::string fill = marker % 2 == 0 ? color : "#ffffff";
  const int shape = marker / 2, corners = shape + 2;
  if (shape == 0) return svg.Circle(centre, 4.0, fill, pen);
  std::vector<Px> points;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2.0 * kPi * i / corners;
    points.push_back({centre.x + 5.0 * std::sin(turn), centre.y - 5.0 * std::cos(turn)});
  }
  svg.Polygon(points, fill, pen);
}

void DrawArrow(SvgDocument& svg, const Arrow& arrow, int marker) {
  svg.OpenGroup("run-arrow", "run-" + std::to_string(arrow.row->run));
  svg.Line(arrow.tail, Along(arrow, kArrowPx - 9.0, 0.0), {arrow.color, 2.2, "", 1.0});
  svg.Polygon({arrow.point, Along(arrow, kArrowPx - 12.0, 5.0), Along(arrow, kArrowPx - 9.0, 0.0),
               Along(arrow, kArrowPx - 12.0, -5.0)},
              arrow.color, {arrow.color, 0.5, "", 1.0});
  DrawMarker(svg, arrow.tail, marker, arrow.color);
  svg.CloseGroup();
}

// The arrow's shaft as a row of small boxes, for labels to keep clear of.
void AddObstacles(const Arrow& arrow, std::vector<Box>& taken) {
  for (double s = 0.0; s <= kArrowPx; s += 6.0) {
    const Px p = Along(arrow, s, 0.0);
    taken.push_back({p.x - 5, p.y - 5, p.x + 5, p.y + 5});
  }
}

// Tries places round the tail, near ones first, and takes the first that is free.
Px FreePlace(const Arrow& arrow, double width, const PlotArea& area, const std::vector<Box>& taken,
             Box& box) {
  const double height = kSmallText;
  for (const double distance : {9.0, 16.0, 24.0, 34.0}) {
    for (const double turn_deg : {0.0, 25.0, -25.0, 50.0, -50.0, 75.0, -75.0, 100.0, -100.0}) {
      const double turn = Radians(turn_deg);
      const Px away{-arrow.direction.x * std::cos(turn) + arrow.direction.y * std::sin(turn),
                    -arrow.direction.y * std::cos(turn) - arrow.direction.x * std::sin(turn)};
      const Px centre{arrow.tail.x + away.x * (distance + width / 2),
                      arrow.tail.y + away.y * (distance + height / 2)};
      box = {centre.x - width / 2, centre.y - height / 2, centre.x + width / 2,
             centre.y + height / 2};
      const bool inside =
          box.left > area.corner.x + 2 && box.right < area.corner.x + area.width - 2;
      const bool free = inside && std::none_of(taken.begin(), taken.end(), [&](const Box& other) {
                          return box.Overlaps(other);
                        });
      if (free) return {box.left, box.bottom - 1.5};
    }
  }
  return {box.left, box.bottom - 1.5};
}

void DrawLabels(SvgDocument& svg, const PlotArea& area, const std::vector<Arrow>& arrows) {
  std::vector<Box> taken;
  for (const Arrow& arrow : arrows) AddObstacles(arrow, taken);
  for (const Arrow& arrow : arrows) {
    std::string label = std::to_string(arrow.row->run);
    if (!arrow.row->docked) label += " " + arrow.row->outcome;
    Box box{};
    const Px at = FreePlace(arrow, kLetterPx * static_cast<double>(label.size()), area, taken, box);
    svg.Text(at, label, {kSmallText, arrow.row->docked ? "#5a6b85" : kRed});
    taken.push_back(box);
  }
}

// The span of alpha that the paper tested, and rings of equal distance.
void DrawPolarGuides(SvgDocument& svg, const PlotArea& area) {
  const Pen guide{"#b9c4d0", 1.0, "3 4", 1.0};
  for (double r = 1.0; r < area.x.high; r += 1.0) {
    std::vector<Px> arc;
    for (double alpha_deg = -40.0; alpha_deg <= 40.0; alpha_deg += 2.0) {
      const double x = r * std::cos(Radians(alpha_deg)), y = r * std::sin(Radians(alpha_deg));
      if (x < area.x.high && std::abs(y) < area.y.high) arc.push_back(area.At(x, y));
    }
    svg.Polyline(arc, guide);
  }
  const double reach =
      std::min(area.y.high / std::sin(Radians(40.0)), area.x.high / std::cos(Radians(40.0)));
  for (const double alpha_deg : {-40.0, 0.0, 40.0}) {
    const double r = alpha_deg == 0.0 ? area.x.high : reach;
    svg.Line(area.At(0, 0),
             area.At(r * std::cos(Radians(alpha_deg)), r * std::sin(Radians(alpha_deg))), guide);
  }
}

/// Draws the key of the colours and the tails' markers; returns where it ends.
double DrawKey(SvgDocument& svg, Px at, const std::map<std::string, int>& markers) {
  const std::array<std::pair<const char*, const char*>, 2> colors{
      {{kBlue, "docked"}, {kRed, "not docked (cause)"}}};
  for (const auto& [color, word] : colors) {
    svg.Line(at, {at.x + 20, at.y}, {color, 2.2, "", 1.0});
    svg.Polygon({{at.x + 30, at.y}, {at.x + 18, at.y - 5}, {at.x + 18, at.y + 5}}, color,
                {color, 0.5, "", 1.0});
    svg.Text({at.x + 36, at.y + 4}, word, {12, "#333333"});
    at.x += 52 + 6.6 * static_cast<double>(std::string(word).size());
  }
  std::map<int, std::string> soils;
  for (const auto& [soil, marker] : markers) soils[marker] = soil.empty() ? "-" : soil;
  if (!soils.empty()) svg.Text({at.x, at.y + 4}, "soil:", {12, "#333333"});
  at.x += 36;
  for (const auto& [marker, soil] : soils) {
    svg.OpenGroup("soil-key");
    DrawMarker(svg, {at.x + 4, at.y}, marker, "#555555");
    svg.Text({at.x + 13, at.y + 4}, soil, {12, "#333333"});
    svg.CloseGroup();
    at.x += 28 + 6.6 * static_cast<double>(soil.size());
  }
  return at.x;
}

}  // namespace

bool HasStartPoses(const RowColumns& columns) { return LabelsOf(columns).has_value(); }

std::string GridPlot(const std::string& title, const RowColumns& columns,
                     const std::vector<RunResult>& rows, const ConeModel& cone) {
  const auto at = LabelsOf(columns);
  DOCKYARD_CHECK(at.has_value());
  const PlotArea area = GridArea(rows, *at);
  const auto docked =
      std::count_if(rows.begin(), rows.end(), [](const RunResult& row) { return row.docked; });
  const std::map<std::string, int> markers = MarkersOf(rows, *at);
  const Px key{area.corner.x, 54};
  SvgDocument trial(1.0, 1.0, "");  // only to learn how wide the key is
  const double width = std::max({area.width + 110.0, 640.0, DrawKey(trial, key, markers) + 10.0});
  SvgDocument svg(width, area.height + 134.0, title);
  svg.Text({area.corner.x, 30},
           title + ": " + BriefRate(static_cast<int>(docked), static_cast<int>(rows.size())),
           {16, "#111111", Anchor::kStart, true});
  DrawKey(svg, key, markers);
  area.DrawAxes(svg, "out along the cone's axis, x [m]", "to the left, y [m]");
  DrawPolarGuides(svg, area);
  DrawStation(svg, area, cone);
  svg.Text(area.At(-0.42, 0.55), "station", {11, "#444444", Anchor::kMiddle});
  const std::vector<Arrow> arrows = Arrows(rows, *at, area);
  for (const Arrow& arrow : arrows) {
    DrawArrow(svg, arrow, at->soil ? markers.at(arrow.row->labels[*at->soil]) : 0);
  }
  DrawLabels(svg, area, arrows);
  return svg.Finish();
}

}  // namespace dockyard::axel
