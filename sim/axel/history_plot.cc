#include <algorithm>
#include <cmath>
#include <functional>

#include "controller/base/check.h"
#include "sim/axel/run_plots.h"

namespace dockyard::axel {
namespace {

constexpr double kLeft = 82.0, kWidth = 840.0;
constexpr double kPanelHeight = 140.0, kPanelGap = 36.0;

struct Curve {
  std::string name;
  Pen pen;
  std::function<double(const HistorySample&)> value;
};

struct Panel {
  std::string label;
  double least_span;  // a quiet signal is not blown up to fill the panel
  std::vector<Curve> curves;
};

// Heading against the cone's axis (Tsai et al., Eq. 1): 0 when the arm points into the station.
double Heading(const Pose2& X_DR) { return Degrees(ToDockingCoords(X_DR).h); }

/// A channel of the history by name.
std::function<double(const HistorySample&)> Channel(const std::vector<Column>& channels,
                                                    const char* name, double scale = 1.0) {
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const Column& column) { return column.name == name; });
  DOCKYARD_CHECK(found != channels.end());
  const auto index = static_cast<std::size_t>(found - channels.begin());
  return [index, scale](const HistorySample& sample) { return scale * sample.channels[index]; };
}

std::vector<Panel> Panels(const std::vector<Column>& channels) {
  const Pen black{"#222222", 1.4, "", 1.0}, blue{"#1f5fbf", 1.4, "", 1.0};
  const Pen red{"#c8321e", 1.4, "", 1.0}, green{"#2a8f5c", 1.4, "", 1.0};
  const auto depth_cm = Channel(channels, "tip_depth_m", 100.0);
  const auto left_cm = Channel(channels, "left_sinkage_m", 100.0);
  const auto right_cm = Channel(channels, "right_sinkage_m", 100.0);
  return {
      {"attitude [deg]",
       10.0,
       {{"roll", green, Channel(channels, "roll_deg")},
        {"pitch (nose down +)", red, Channel(channels, "pitch_deg")},
        {"heading against the axis", black,
         [](const HistorySample& s) { return Heading(s.X_DR); }}}},
      {"forces [N]",
       20.0,
       {{"tether tension", blue, Channel(channels, "tension_n")},
        {"cone on arm", red, Channel(channels, "cone_force_n")}}},
      {"currents [A]",
       0.5,
       {{"left wheel", green, Channel(channels, "left_current_a")},
        {"right wheel", red, Channel(channels, "right_current_a")},
        {"spool", blue, Channel(channels, "spool_current_a")}}},
      {"near the cone [cm]",
       10.0,
       {{"tip depth", blue,
         [depth_cm](const HistorySample& s) { return std::max(-50.0, depth_cm(s)); }},
        {"station shift", red, Channel(channels, "station_shift_m", 100.0)},
        {"deeper wheel's sinkage", green,
         [left_cm, right_cm](const HistorySample& s) {
           return std::max(left_cm(s), right_cm(s));
         }}}},
  };
}

DataRange ValueRange(const Panel& panel, const std::vector<HistorySample>& history) {
  DataRange range = DataRange::Nothing();
  for (const Curve& curve : panel.curves) {
    for (const HistorySample& sample : history) range.Hold(curve.value(sample));
  }
  range.Hold(0.0);
  const double margin = std::max(0.06 * range.span(), 0.5 * (panel.least_span - range.span()));
  return {range.low - margin, range.high + margin};
}

// The least and the greatest value in each pixel column keep every peak and bound the file's size.
std::vector<Px> CurvePoints(const Curve& curve, const PlotArea& area,
                            const std::vector<HistorySample>& history) {
  std::vector<Px> points;
  std::size_t i = 0;
  while (i < history.size()) {
    const double column = std::floor(area.At(history[i].time_s, 0.0).x);
    std::size_t least = history.size(), greatest = history.size();
    for (; i < history.size() && std::floor(area.At(history[i].time_s, 0.0).x) == column; ++i) {
      const double value = curve.value(history[i]);
      if (!std::isfinite(value)) continue;
      if (least == history.size() || value < curve.value(history[least])) least = i;
      if (greatest == history.size() || value > curve.value(history[greatest])) greatest = i;
    }
    for (const std::size_t kept : {std::min(least, greatest), std::max(least, greatest)}) {
      if (kept == history.size()) continue;
      points.push_back(area.At(history[kept].time_s, curve.value(history[kept])));
      if (least == greatest) break;
    }
  }
  return points;
}

void DrawPanel(SvgDocument& svg, const Panel& panel, const PlotArea& area,
               const std::vector<HistorySample>& history, bool last) {
  area.DrawAxes(svg, last ? "time [s]" : "", panel.label, last);
  std::vector<std::pair<std::string, Pen>> legend;
  for (const Curve& curve : panel.curves) {
    svg.Polyline(CurvePoints(curve, area, history), curve.pen);
    legend.push_back({curve.name, curve.pen});
  }
  DrawLegend(svg, {area.corner.x + 4, area.corner.y - 6}, legend);
}

// A strip of the controller's phases; names where they fit.
void DrawPhases(SvgDocument& svg, const PlotArea& area, const std::vector<HistorySample>& history) {
  const char* shades[] = {"#dfe7f2", "#f2e8da"};
  const double top = 46.0, height = 20.0;
  int shade = 0;
  for (std::size_t begin = 0; begin < history.size();) {
    std::size_t end = begin;
    while (end < history.size() && history[end].phase == history[begin].phase) ++end;
    const double until_s = end < history.size() ? history[end].time_s : area.x.high;
    const double left = area.At(history[begin].time_s, 0.0).x, right = area.At(until_s, 0.0).x;
    svg.Rect({left, top}, right - left, height, shades[shade]);
    const std::string& name = history[begin].phase;
    if (right - left > 6.4 * static_cast<double>(name.size())) {
      svg.Text({0.5 * (left + right), top + 14}, name, {10.5, "#333333", Anchor::kMiddle});
    }
    shade = 1 - shade;
    begin = end;
  }
}

void DrawImageTimes(SvgDocument& svg, const PlotArea& area,
                    const std::vector<SightingSample>& sightings) {
  for (const SightingSample& sample : sightings) {
    const Px at = area.At(sample.time_s, area.y.low);
    const std::string color = sample.report.accepted ? "#1f5fbf" : "#c8321e";
    svg.Polygon({{at.x, at.y - 8}, {at.x + 4, at.y}, {at.x - 4, at.y}},
                sample.report.accepted ? color : "#ffffff", {color, 1.0, "", 1.0});
  }
}

}  // namespace

std::string HistoryPlot(const RunRecord& record) {
  const std::vector<Panel> panels = Panels(record.channels);
  const std::vector<HistorySample>& history = record.history;
  const double top = 92.0;
  const double rows = static_cast<double>(panels.size());
  const std::string title = RunTitle(record);
  SvgDocument svg(kLeft + kWidth + 30, top + rows * (kPanelHeight + kPanelGap) + 24, title);
  svg.Text({kLeft, 28}, title, {14, "#111111", Anchor::kStart, true});
  const double end_s = history.empty() ? 1.0 : std::max(1.0, history.back().time_s);
  PlotArea area{{kLeft, top}, kWidth, kPanelHeight, {0.0, end_s}, {0.0, 1.0}};
  DrawPhases(svg, area, history);
  for (const Panel& panel : panels) {
    area.y = ValueRange(panel, history);
    DrawPanel(svg, panel, area, history, &panel == &panels.back());
    if (&panel == &panels.front()) DrawImageTimes(svg, area, record.sightings);
    area.corner.y += kPanelHeight + kPanelGap;
  }
  return svg.Finish();
}

}  // namespace dockyard::axel
