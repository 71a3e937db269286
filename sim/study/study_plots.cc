#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sim/campaign/statistics.h"
#include "sim/campaign/svg.h"
#include "sim/study/study_results.h"

namespace dockyard {
namespace {

const std::array<const char*, 6> kColors{"#1f5fa8", "#d9772b", "#2e8b57",
                                         "#b8323c", "#7b5ea7", "#666666"};

const char* Color(std::size_t i) { return kColors[i % kColors.size()]; }

int FactorIndex(const Study& study, const std::string& key) {
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    if (study.factors[i].key == key) return static_cast<int>(i);
  }
  return -1;
}

/// "alpha_deg" of "start.alpha_deg".
std::string LastName(const std::string& key) { return key.substr(key.rfind('.') + 1); }

int LevelsOf(const Study& study, int factor) {
  return factor < 0
             ? 1
             : static_cast<int>(study.factors[static_cast<std::size_t>(factor)].values.size());
}

bool AtLevel(const StudyPoint& point, int factor, int level) {
  return factor < 0 || point.level[static_cast<std::size_t>(factor)] == level;
}

struct Axes {
  int x = -1, curves = -1, panels = -1;
};

std::vector<const StudyRow*> RowsAt(const Study& study, const std::vector<StudyRow>& rows,
                                    const Axes& axes, int x, int curve, int panel) {
  std::vector<const StudyRow*> found;
  for (const StudyRow& row : rows) {
    const StudyPoint& point = study.points[static_cast<std::size_t>(row.point)];
    if (point.changed < 0 && AtLevel(point, axes.x, x) && AtLevel(point, axes.curves, curve) &&
        AtLevel(point, axes.panels, panel)) {
      found.push_back(&row);
    }
  }
  return found;
}

struct Curve {
  std::vector<double> x;
  std::vector<Spread> y;
};

Curve MakeCurve(const Study& study, const std::vector<StudyRow>& rows, const Axes& axes, int curve,
                int panel, const std::string& measure) {
  Curve made;
  const StudyFactor& factor = study.factors[static_cast<std::size_t>(axes.x)];
  for (int level = 0; level < LevelsOf(study, axes.x); ++level) {
    const Spread spread = SpreadOf(measure, RowsAt(study, rows, axes, level, curve, panel));
    if (spread.count == 0) continue;
    const std::string& label = factor.labels[static_cast<std::size_t>(level)];
    made.x.push_back(factor.numeric() ? std::stod(label) : level);
    made.y.push_back(spread);
  }
  return made;
}

void DrawCurve(SvgDocument& svg, const PlotArea& area, const Curve& curve,
               const std::string& color) {
  std::vector<Px> band, line;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    band.push_back(area.At(curve.x[i], curve.y[i].high));
    line.push_back(area.At(curve.x[i], curve.y[i].median));
  }
  for (std::size_t i = curve.x.size(); i-- > 0;) {
    band.push_back(area.At(curve.x[i], curve.y[i].low));
  }
  if (curve.x.size() > 1) {
    svg.OpenGroup("band");
    svg.Polygon(band, color + "\" fill-opacity=\"0.16", {color, 0.4, "", 0.4});
    svg.CloseGroup();
  }
  svg.Polyline(line, {color, 1.8, "", 1.0});
  for (const Px& p : line) svg.Circle(p, 2.4, color, {color, 0.5, "", 1.0});
}

DataRange XRange(const StudyFactor& factor) {
  DataRange range = DataRange::Nothing();
  for (std::size_t i = 0; i < factor.labels.size(); ++i) {
    range.Hold(factor.numeric() ? std::stod(factor.labels[i]) : static_cast<double>(i));
  }
  const double pad = 0.03 * std::max(range.span(), 1e-6);
  return {range.low - pad, range.high + pad};
}

struct Bar {
  std::string label;
  double share_change = 0.0;    // of docked, 0 to 1
  double tension_change = 0.0;  // of the mean peak [N]
};

std::vector<const StudyRow*> RowsChanged(const Study& study, const std::vector<StudyRow>& rows,
                                         int changed, int level) {
  std::vector<const StudyRow*> found;
  for (const StudyRow& row : rows) {
    const StudyPoint& point = study.points[static_cast<std::size_t>(row.point)];
    if (point.changed == changed && point.changed_level == level) found.push_back(&row);
  }
  return found;
}

/// The bars of one key, and how long its longest is.
struct BarGroup {
  std::string key;
  std::vector<Bar> bars;
  double reach() const {
    double most = 0.0;
    for (const Bar& bar : bars) most = std::max(most, std::abs(bar.share_change));
    return most;
  }
};

std::vector<BarGroup> BarGroups(const Study& study, const std::vector<StudyRow>& rows) {
  const auto base = RowsChanged(study, rows, -1, -1);
  const double share = SpreadOf("docked", base).mean;
  const double tension = SpreadOf("tension_peak_n", base).mean;
  std::vector<BarGroup> groups;
  for (std::size_t i = 0; i < study.one_at_a_time.size(); ++i) {
    const StudyFactor& factor = study.one_at_a_time[i];
    BarGroup group{factor.key, {}};
    for (std::size_t level = 0; level < factor.values.size(); ++level) {
      const auto there = RowsChanged(study, rows, static_cast<int>(i), static_cast<int>(level));
      if (there.empty()) continue;
      group.bars.push_back({factor.labels[level], SpreadOf("docked", there).mean - share,
                            SpreadOf("tension_peak_n", there).mean - tension});
    }
    if (!group.bars.empty()) groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const BarGroup& a, const BarGroup& b) { return a.reach() > b.reach(); });
  return groups;
}

void DrawBar(SvgDocument& svg, const PlotArea& area, double value, double top, double height,
             const std::string& color) {
  const double zero = area.At(0.0, 0.0).x, end = area.At(value, 0.0).x;
  svg.Rect({std::min(zero, end), top}, std::max(0.8, std::abs(end - zero)), height, color);
}

}  // namespace

std::string StudyCurves(const Study& study, const std::vector<StudyRow>& rows) {
  const Axes axes{FactorIndex(study, study.x), FactorIndex(study, study.curves),
                  FactorIndex(study, study.panels)};
  if (axes.x < 0) return "";
  const int columns = LevelsOf(study, axes.panels);
  constexpr double kLeft = 70, kTop = 74, kWide = 300, kHigh = 170, kGapX = 70, kGapY = 56;
  const double width = kLeft + columns * (kWide + kGapX);
  const double height = kTop + static_cast<double>(study.measures.size()) * (kHigh + kGapY) + 4;
  SvgDocument svg(std::max(width, 520.0), height, study.name);
  svg.Text({kLeft, 26}, study.name + ", " + std::to_string(rows.size()) + " runs",
           {15, "#111111", Anchor::kStart, true});
  std::vector<std::pair<std::string, Pen>> legend;
  for (int i = 0; axes.curves >= 0 && i < LevelsOf(study, axes.curves); ++i) {
    const StudyFactor& factor = study.factors[static_cast<std::size_t>(axes.curves)];
    legend.push_back({factor.labels[static_cast<std::size_t>(i)],
                      {Color(static_cast<std::size_t>(i)), 2.4, "", 1.0}});
  }
  DrawLegend(svg, {kLeft, 46}, legend);
  double top = kTop;
  for (const std::string& measure : study.measures) {
    DataRange range = measure == "docked" ? DataRange{0.0, 1.0} : DataRange::Nothing();
    std::vector<std::vector<Curve>> curves(static_cast<std::size_t>(columns));
    for (int panel = 0; panel < columns; ++panel) {
      for (int i = 0; i < LevelsOf(study, axes.curves); ++i) {
        Curve curve = MakeCurve(study, rows, axes, i, panel, measure);
        for (const Spread& y : curve.y) {
          range.Hold(y.low);
          range.Hold(y.high);
        }
        curves[static_cast<std::size_t>(panel)].push_back(std::move(curve));
      }
    }
    if (range.empty()) range = {0.0, 1.0};
    if (range.span() <= 0.0) range = {range.low - 0.5, range.high + 0.5};
    const double pad = measure == "docked" ? 0.03 : 0.05 * range.span();
    for (int panel = 0; panel < columns; ++panel) {
      const PlotArea area{{kLeft + panel * (kWide + kGapX), top},
                          kWide,
                          kHigh,
                          XRange(study.factors[static_cast<std::size_t>(axes.x)]),
                          {range.low - pad, range.high + pad}};
      area.DrawAxes(svg, LastName(study.x), measure);
      if (axes.panels >= 0) {
        const StudyFactor& factor = study.factors[static_cast<std::size_t>(axes.panels)];
        svg.Text({area.corner.x + 6, area.corner.y - 5},
                 LastName(factor.key) + " " + factor.labels[static_cast<std::size_t>(panel)],
                 {11, "#444444"});
      }
      std::size_t color = 0;
      for (const Curve& curve : curves[static_cast<std::size_t>(panel)]) {
        DrawCurve(svg, area, curve, Color(color++));
      }
    }
    top += kHigh + kGapY;
  }
  return svg.Finish();
}

std::string StudyBars(const Study& study, const std::vector<StudyRow>& rows) {
  const std::vector<BarGroup> groups = BarGroups(study, rows);
  if (groups.empty()) return "";
  constexpr double kLeft = 330, kTop = 84, kWide = 260, kGap = 50, kBarPx = 11, kGroupGap = 7;
  double high = 0.0;
  DataRange share = {-0.05, 0.05}, tension = {-5.0, 5.0};
  for (const BarGroup& group : groups) {
    high += kBarPx * static_cast<double>(group.bars.size()) + kGroupGap;
    for (const Bar& bar : group.bars) {
      share.Hold(bar.share_change);
      tension.Hold(bar.tension_change);
    }
  }
  SvgDocument svg(kLeft + 2 * (kWide + kGap), kTop + high + 60, study.name);
  const auto base = RowsChanged(study, rows, -1, -1);
  const Spread docked = SpreadOf("docked", base);
  svg.Text({16, 26}, study.name + ": one key changed at a time",
           {15, "#111111", Anchor::kStart, true});
  svg.Text({16, 48},
           "unchanged: " +
               BriefRate(static_cast<int>(std::lround(docked.mean * docked.count)), docked.count) +
               ", peak tension " +
               std::to_string(std::lround(SpreadOf("tension_peak_n", base).mean)) + " N",
           {12, "#333333"});
  const auto padded = [](const DataRange& range) {
    return DataRange{range.low - 0.05 * range.span(), range.high + 0.05 * range.span()};
  };
  const PlotArea left{{kLeft, kTop}, kWide, high, padded(share), {0.0, 1.0}};
  const PlotArea right{{kLeft + kWide + kGap, kTop}, kWide, high, padded(tension), {0.0, 1.0}};
  for (const auto& [area, title] : {std::pair{left, "change of the docked share"},
                                    std::pair{right, "change of the mean peak tension [N]"}}) {
    const double step = NiceStep(area.x.span(), 4);
    for (double i = std::ceil(area.x.low / step); i * step <= area.x.high; ++i) {
      const Px at = area.At(i * step, 0.0);
      svg.Line({at.x, kTop}, {at.x, kTop + high}, {i == 0 ? "#444444" : "#e0e0e0", 1.0, "", 1.0});
      svg.Text({at.x, kTop + high + 16}, TickText(i * step, step),
               {11, "#444444", Anchor::kMiddle});
    }
    svg.Text({area.corner.x + kWide / 2, kTop + high + 36}, title,
             {12, "#222222", Anchor::kMiddle});
  }
  double top = kTop;
  for (const BarGroup& group : groups) {
    std::size_t color = 0;
    for (const Bar& bar : group.bars) {
      svg.Text({kLeft - 8, top + kBarPx - 2}, group.key + " = " + bar.label,
               {10, "#333333", Anchor::kEnd});
      DrawBar(svg, left, bar.share_change, top + 1, kBarPx - 2, Color(color));
      DrawBar(svg, right, bar.tension_change, top + 1, kBarPx - 2, Color(color++));
      top += kBarPx;
    }
    top += kGroupGap;
  }
  return svg.Finish();
}

}  // namespace dockyard
