#include <algorithm>
#include <cctype>

#include "controller/base/check.h"
#include "sim/report/svg.h"
#include "sim/study/plot_labels.h"
#include "sim/study/study_results.h"

namespace dockyard {
namespace {

int FactorIndex(const Study& study, const std::string& key) {
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    if (study.factors[i].key == key) return static_cast<int>(i);
  }
  return -1;
}

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

Curve MakeCurve(const Study& study, const std::vector<Column>& measured,
                const std::vector<StudyRow>& rows, const Axes& axes, int curve, int panel,
                const std::string& measure) {
  Curve made;
  const StudyFactor& factor = study.factors[static_cast<std::size_t>(axes.x)];
  for (int level = 0; level < LevelsOf(study, axes.x); ++level) {
    const Spread spread =
        SpreadOf(measured, measure, RowsAt(study, rows, axes, level, curve, panel));
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

constexpr double kLeft = 70, kTop = 74, kWide = 300, kHigh = 170, kGapX = 70, kGapY = 56;  // [px]

/// By panel, then by curve.
using PanelCurves = std::vector<std::vector<Curve>>;

PanelCurves MakeCurves(const Study& study, const std::vector<Column>& measured,
                       const std::vector<StudyRow>& rows, const Axes& axes,
                       const std::string& measure) {
  PanelCurves curves(static_cast<std::size_t>(LevelsOf(study, axes.panels)));
  for (std::size_t panel = 0; panel < curves.size(); ++panel) {
    for (int i = 0; i < LevelsOf(study, axes.curves); ++i) {
      curves[panel].push_back(
          MakeCurve(study, measured, rows, axes, i, static_cast<int>(panel), measure));
    }
  }
  return curves;
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
void DrawMeasure(SvgDocument& svg, const Study& study, const Axes& axes, const PanelCurves& panels,
                 const Column& column, double top) {
  const DataRange y = YRange(panels, column.name == "docked");
  const StudyFactor& x = study.factors[static_cast<std::size_t>(axes.x)];
  for (std::size_t panel = 0; panel < panels.size(); ++panel) {
    const double left = kLeft + static_cast<double>(panel) * (kWide + kGapX);
    const PlotArea area{{left, top}, kWide, kHigh, XRange(x), y};
    area.DrawAxes(svg, LastName(study.x), AxisLabel(column));
    if (axes.panels >= 0) {
      const StudyFactor& factor = study.factors[static_cast<std::size_t>(axes.panels)];
      svg.Text({left + 6, top - 5}, LastName(factor.key) + " " + factor.labels[panel],
               {11, "#444444"});
    }
    std::size_t color = 0;
    for (const Curve& curve : panels[panel]) DrawCurve(svg, area, curve, StudyColor(color++));
  }
}

}  // namespace

std::string AxisLabel(const Column& column) {
  if (column.name == "docked") return "docked share";
  std::string suffix = "_", label = column.name;
  for (const unsigned char c : column.unit) {
    suffix += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '_';  // "N", "m/s"
  }
  if (!column.unit.empty() && label.ends_with(suffix)) label.erase(label.size() - suffix.size());
  std::replace(label.begin(), label.end(), '_', ' ');
  return column.unit.empty() ? label : label + " [" + column.unit + "]";
}

std::string StudyCurves(const Study& study, const RowColumns& columns,
                        const std::vector<StudyRow>& rows) {
  const Axes axes{FactorIndex(study, study.x), FactorIndex(study, study.curves),
                  FactorIndex(study, study.panels)};
  if (axes.x < 0) return "";
  const std::vector<Column> measured = StudyColumns(columns);
  const double width = kLeft + LevelsOf(study, axes.panels) * (kWide + kGapX);
  const double height = kTop + static_cast<double>(study.measures.size()) * (kHigh + kGapY) + 4;
  SvgDocument svg(std::max(width, 520.0), height, study.name);
  svg.Text({kLeft, 26}, study.name + ", " + std::to_string(rows.size()) + " runs",
           {15, "#111111", Anchor::kStart, true});
  std::vector<std::pair<std::string, Pen>> legend;
  for (int i = 0; axes.curves >= 0 && i < LevelsOf(study, axes.curves); ++i) {
    const StudyFactor& factor = study.factors[static_cast<std::size_t>(axes.curves)];
    legend.push_back({factor.labels[static_cast<std::size_t>(i)],
                      {StudyColor(static_cast<std::size_t>(i)), 2.4, "", 1.0}});
  }
  DrawLegend(svg, {kLeft, 46}, legend);
  double top = kTop;
  for (const std::string& measure : study.measures) {
    const auto column = std::find_if(measured.begin(), measured.end(),
                                     [&](const Column& each) { return each.name == measure; });
    DOCKYARD_CHECK(column != measured.end());
    DrawMeasure(svg, study, axes, MakeCurves(study, measured, rows, axes, measure), *column, top);
    top += kHigh + kGapY;
  }
  return svg.Finish();
}

}  // namespace dockyard
