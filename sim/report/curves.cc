#include <algorithm>
#include <cctype>
#include <map>

#include "controller/base/check.h"
#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/report/plot_labels.h"
#include "sim/report/points.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

/// A label whose texts are the levels of an axis, in order; without a name one level of all rows.
struct Axis {
  std::string label;
  std::vector<std::string> levels{""};
  bool numeric = false;

  bool Holds(const RunResult& row, const RowColumns& columns, std::size_t level) const {
    return label.empty() || LabelOf(row, columns, label) == levels[level];
  }
  double At(std::size_t level) const {
    return numeric ? NumberFromText(levels[level]).value() : static_cast<double>(level);
  }
};

Axis MakeAxis(const std::string& label, const RowColumns& columns, const Rows& rows) {
  Axis axis{label};
  if (label.empty()) return axis;
  axis.levels = LevelsOf(rows, columns, label);
  axis.numeric = std::all_of(axis.levels.begin(), axis.levels.end(), [](const std::string& text) {
    return NumberFromText(text).has_value();
  });
  if (axis.numeric) {
    std::sort(axis.levels.begin(), axis.levels.end(),
              [](const auto& a, const auto& b) { return *NumberFromText(a) < *NumberFromText(b); });
  }
  return axis;
}

struct Axes {
  Axis x, curves, panels;
};

struct Curve {
  std::vector<double> x;
  std::vector<Spread> y;
};

Curve MakeCurve(const RowColumns& columns, const Rows& rows, const Axes& axes, std::size_t curve,
                std::size_t panel, const std::string& measure) {
  std::vector<Rows> by_x(axes.x.levels.size());
  std::map<std::string, std::size_t> level;
  for (std::size_t i = 0; i < axes.x.levels.size(); ++i) level[axes.x.levels[i]] = i;
  for (const RunResult* row : rows) {
    if (!axes.curves.Holds(*row, columns, curve) || !axes.panels.Holds(*row, columns, panel)) {
      continue;
    }
    by_x[level.at(LabelOf(*row, columns, axes.x.label))].push_back(row);
  }
  Curve made;
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    const Spread spread = SpreadOf(columns, measure, by_x[i]);
    if (spread.count == 0) continue;
    made.x.push_back(axes.x.At(i));
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

DataRange XRange(const Axis& x) {
  DataRange range = DataRange::Nothing();
  for (std::size_t i = 0; i < x.levels.size(); ++i) range.Hold(x.At(i));
  const double pad = 0.03 * std::max(range.span(), 1e-6);
  return {range.low - pad, range.high + pad};
}

constexpr double kLeft = 70, kTop = 74, kWide = 300, kHigh = 170, kGapX = 70, kGapY = 56;  // [px]

/// By panel, then by curve.
using PanelCurves = std::vector<std::vector<Curve>>;

PanelCurves MakeCurves(const RowColumns& columns, const Rows& rows, const Axes& axes,
                       const std::string& measure) {
  PanelCurves panels(axes.panels.levels.size());
  for (std::size_t panel = 0; panel < panels.size(); ++panel) {
    for (std::size_t curve = 0; curve < axes.curves.levels.size(); ++curve) {
      panels[panel].push_back(MakeCurve(columns, rows, axes, curve, panel, measure));
    }
  }
  return panels;
}

/// Of all curves with their bands; a share's is whole.
DataRange YRange(const PanelCurves& panels, bool is_share) {
  if (is_share) return {-0.03, 1.03};
  DataRange range = DataRange::Nothing();
  for (const auto& curves : panels) {
    for (const Curve& curve : curves) {
      for (const Spread& y : curve.y) {
        range.Hold(y.low);
        range.Hold(y.high);
      }
    }
  }
  if (range.empty()) range = {0.0, 1.0};
  if (range.span() <= 0.0) range = {range.low - 0.5, range.high + 0.5};
  return {range.low - 0.05 * range.span(), range.high + 0.05 * range.span()};
}

/// A row of panels, one measure.
void DrawMeasure(SvgDocument& svg, const Axes& axes, const PanelCurves& panels,
                 const Column& column, double top) {
  const DataRange y = YRange(panels, column.name == kSuccess);
  for (std::size_t panel = 0; panel < panels.size(); ++panel) {
    const double left = kLeft + static_cast<double>(panel) * (kWide + kGapX);
    const PlotArea area{{left, top}, kWide, kHigh, XRange(axes.x), y};
    area.DrawAxes(svg, LastName(axes.x.label), AxisLabel(column));
    if (!axes.panels.label.empty()) {
      svg.Text({left + 6, top - 5}, LastName(axes.panels.label) + " " + axes.panels.levels[panel],
               {11, "#444444"});
    }
    std::size_t color = 0;
    for (const Curve& curve : panels[panel]) DrawCurve(svg, area, curve, CurveColor(color++));
  }
}

}  // namespace

std::string AxisLabel(const Column& column) {
  if (column.name == kSuccess) return "share of successes";
  std::string suffix = "_", label = column.name;
  for (const unsigned char c : column.unit) {
    suffix += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '_';  // "N", "m/s"
  }
  if (!column.unit.empty() && label.ends_with(suffix)) label.erase(label.size() - suffix.size());
  std::replace(label.begin(), label.end(), '_', ' ');
  return column.unit.empty() ? label : label + " [" + column.unit + "]";
}

std::string CurvesPlot(const std::string& title, const Figures& figures, const RowColumns& columns,
                       const std::vector<RunResult>& rows) {
  if (figures.x.empty()) return "";
  const Rows unchanged = UnchangedRows(rows, columns);
  const Axes axes{MakeAxis(figures.x, columns, unchanged),
                  MakeAxis(figures.curves, columns, unchanged),
                  MakeAxis(figures.panels, columns, unchanged)};
  const double width = kLeft + static_cast<double>(axes.panels.levels.size()) * (kWide + kGapX);
  const double height = kTop + static_cast<double>(figures.measures.size()) * (kHigh + kGapY) + 4;
  SvgDocument svg(std::max(width, 520.0), height, title);
  svg.Text({kLeft, 26}, title + ", " + CountText(rows.size(), "run"),
           {15, "#111111", Anchor::kStart, true});
  std::vector<std::pair<std::string, Pen>> legend;
  for (std::size_t i = 0; !figures.curves.empty() && i < axes.curves.levels.size(); ++i) {
    legend.push_back({axes.curves.levels[i], {CurveColor(i), 2.4, "", 1.0}});
  }
  DrawLegend(svg, {kLeft, 46}, legend);
  const std::vector<Column> summed = SummedColumns(columns);
  double top = kTop;
  for (const std::string& measure : figures.measures) {
    const auto column = std::find_if(summed.begin(), summed.end(),
                                     [&](const Column& each) { return each.name == measure; });
    DOCKYARD_CHECK(column != summed.end());
    DrawMeasure(svg, axes, MakeCurves(columns, unchanged, axes, measure), *column, top);
    top += kHigh + kGapY;
  }
  return svg.Finish();
}

}  // namespace dockyard
