#include <algorithm>
#include <cmath>

#include "sim/report/plot_labels.h"
#include "sim/report/run_plots.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

constexpr double kLeft = 82.0, kWidth = 840.0, kTop = 92.0;
constexpr double kPanelHeight = 96.0, kPanelGap = 34.0;

/// Channels that share a panel.
struct Panel {
  std::string group, unit;
  std::vector<const Column*> channels;
};

/// "current_a" of "left_current_a"; the whole name where there is one word before the unit.
std::string GroupOf(const std::string& name) {
  const std::size_t first = name.find('_');
  if (first == std::string::npos || name.find('_', first + 1) == std::string::npos) return name;
  return name.substr(first + 1);
}

std::vector<Panel> PanelsOf(const LoggedRun& run, const std::vector<Column>& channels) {
  std::vector<Panel> panels;
  for (const Column& channel : channels) {
    if (!run.truth.contains(channel.name)) continue;
    const std::string group = GroupOf(channel.name);
    auto panel = std::find_if(panels.begin(), panels.end(),
                              [&](const Panel& known) { return known.group == group; });
    if (panel == panels.end()) {
      panels.push_back({group, channel.unit, {}});
      panel = panels.end() - 1;
    }
    panel->channels.push_back(&channel);
  }
  return panels;
}

DataRange ValueRange(const Panel& panel, const LoggedRun& run) {
  DataRange range = DataRange::Nothing();
  for (const Column* channel : panel.channels) {
    for (const double value : run.truth.at(channel->name)) range.Hold(value);
  }
  if (range.empty()) return {};
  const double margin = std::max(0.06 * range.span(), 1e-6);
  return {range.low - margin, range.high + margin};
}

/// The least and the greatest value in each pixel column keep every peak and bound the file's size.
std::vector<Px> CurvePoints(const std::vector<double>& times_s, const std::vector<double>& values,
                            const PlotArea& area) {
  std::vector<Px> points;
  std::size_t i = 0;
  while (i < times_s.size()) {
    const double column = std::floor(area.At(times_s[i], 0.0).x);
    std::size_t least = times_s.size(), greatest = times_s.size();
    for (; i < times_s.size() && std::floor(area.At(times_s[i], 0.0).x) == column; ++i) {
      if (!std::isfinite(values[i])) continue;
      if (least == times_s.size() || values[i] < values[least]) least = i;
      if (greatest == times_s.size() || values[i] > values[greatest]) greatest = i;
    }
    if (least == times_s.size()) continue;
    for (const std::size_t kept : {std::min(least, greatest), std::max(least, greatest)}) {
      points.push_back(area.At(times_s[kept], values[kept]));
      if (least == greatest) break;
    }
  }
  return points;
}

void DrawPanel(SvgDocument& svg, const Panel& panel, const PlotArea& area, const LoggedRun& run,
               bool last) {
  area.DrawAxes(svg, last ? "time [s]" : "", panel.unit.empty() ? "" : "[" + panel.unit + "]",
                last);
  std::vector<std::pair<std::string, Pen>> legend;
  for (std::size_t i = 0; i < panel.channels.size(); ++i) {
    const Pen pen{CurveColor(i), 1.4, "", 1.0};
    svg.Polyline(CurvePoints(run.times_s, run.truth.at(panel.channels[i]->name), area), pen);
    legend.push_back({panel.channels[i]->name, pen});
  }
  DrawLegend(svg, {area.corner.x + 4, area.corner.y - 6}, legend);
}

/// A strip of the controller's phases; names where they fit.
void DrawPhases(SvgDocument& svg, const PlotArea& area, const LoggedRun& run) {
  const char* shades[] = {"#dfe7f2", "#f2e8da"};
  constexpr double kStrip = 46.0, kHeight = 20.0;
  std::vector<const Timed<LoggedNote>*> phases;
  for (const Timed<LoggedNote>& note : run.notes) {
    if (note.value.name == "phase") phases.push_back(&note);
  }
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const double until_s = i + 1 < phases.size() ? phases[i + 1]->time_s : area.x.high;
    const double left = area.At(phases[i]->time_s, 0.0).x, right = area.At(until_s, 0.0).x;
    svg.Rect({left, kStrip}, right - left, kHeight, shades[i % 2]);
    const std::string& name = phases[i]->value.text;
    if (right - left > 6.4 * static_cast<double>(name.size())) {
      svg.Text({0.5 * (left + right), kStrip + 14}, name, {10.5, "#333333", Anchor::kMiddle});
    }
  }
}

}  // namespace

std::string HistoryPlot(const std::string& title, const LoggedRun& run,
                        const std::vector<Column>& channels) {
  const std::vector<Panel> panels = PanelsOf(run, channels);
  const auto rows = static_cast<double>(panels.size());
  SvgDocument svg(kLeft + kWidth + 30, kTop + rows * (kPanelHeight + kPanelGap) + 24, title);
  svg.Text({kLeft, 28}, title, {14, "#111111", Anchor::kStart, true});
  const double end_s = run.times_s.empty() ? 1.0 : std::max(1.0, run.times_s.back());
  PlotArea area{{kLeft, kTop}, kWidth, kPanelHeight, {0.0, end_s}, {0.0, 1.0}};
  DrawPhases(svg, area, run);
  for (const Panel& panel : panels) {
    area.y = ValueRange(panel, run);
    DrawPanel(svg, panel, area, run, &panel == &panels.back());
    area.corner.y += kPanelHeight + kPanelGap;
  }
  return svg.Finish();
}

}  // namespace dockyard
