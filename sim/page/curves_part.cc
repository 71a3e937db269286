#include "sim/page/curves_part.h"

#include <algorithm>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/report/points.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostCurves = 6, kMostPanels = 8;  // more nobody tells apart

struct Wanted {
  std::string x, curves, panels;  // labels; empty: none
  std::vector<std::string> measures;
};

/// The levels of a label, numbers rising; without a label one level of all rows.
std::vector<std::string> OrderedLevels(const Rows& rows, const RowColumns& columns,
                                       const std::string& label) {
  if (label.empty()) return {""};
  std::vector<std::string> levels = LevelsOf(rows, columns, label);
  const bool numbers = std::all_of(levels.begin(), levels.end(), [](const std::string& text) {
    return NumberFromText(text).has_value();
  });
  if (numbers) {
    std::stable_sort(levels.begin(), levels.end(), [](const auto& a, const auto& b) {
      return *NumberFromText(a) < *NumberFromText(b);
    });
  }
  return levels;
}

bool IsAxis(const Rows& rows, const RowColumns& columns, const std::string& label) {
  const std::vector<std::string> levels = LevelsOf(rows, columns, label);
  return levels.size() > 1 &&
         std::all_of(levels.begin(), levels.end(),
                     [](const std::string& text) { return NumberFromText(text).has_value(); });
}

Rows RowsWith(const Rows& rows, const RowColumns& columns, const std::string& label,
              const std::string& level) {
  if (label.empty()) return rows;
  Rows with;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(with),
               [&](const RunResult* row) { return LabelOf(*row, columns, label) == level; });
  return with;
}

Json PointsOf(const Rows& rows, const RowColumns& columns, const std::string& x,
              const std::string& measure) {
  Json points = Json::array();
  for (const std::string& level : OrderedLevels(rows, columns, x)) {
    const Spread spread = SpreadOf(columns, measure, RowsWith(rows, columns, x, level));
    if (spread.count == 0) continue;
    points.push_back({{"x", *NumberFromText(level)},
                      {"runs", spread.count},
                      {"value", spread.median},
                      {"low", spread.low},
                      {"high", spread.high}});
  }
  return points;
}

void AddFigures(const Wanted& wanted, const Rows& rows, const RowColumns& columns, Json& figures) {
  const std::vector<Column> summed = SummedColumns(columns);
  const std::vector<std::string> panels = OrderedLevels(rows, columns, wanted.panels),
                                 curves = OrderedLevels(rows, columns, wanted.curves);
  if (panels.size() > kMostPanels || curves.size() > kMostCurves) return;
  for (const std::string& measure : wanted.measures) {
    const auto column = std::find_if(summed.begin(), summed.end(),
                                     [&](const Column& each) { return each.name == measure; });
    for (const std::string& panel : panels) {
      const Rows of_panel = RowsWith(rows, columns, wanted.panels, panel);
      Json list = Json::array();
      for (const std::string& curve : curves) {
        const Rows of_curve = RowsWith(of_panel, columns, wanted.curves, curve);
        Json points = PointsOf(of_curve, columns, wanted.x, measure);
        if (!points.empty()) list.push_back({{"name", curve}, {"points", std::move(points)}});
      }
      if (list.empty()) continue;
      figures.push_back({{"x", wanted.x},
                         {"measure", measure},
                         {"unit", column == summed.end() ? "" : column->unit},
                         {"by", wanted.curves},
                         {"where", wanted.panels.empty() ? "" : wanted.panels + " " + panel},
                         {"curves", list}});
    }
  }
}

/// What tells the curves of a factor apart: the arms, else the first other factor with a few
/// levels.
std::string CurvesFor(const Campaign& campaign, const std::string& x) {
  if (campaign.arms.size() > 1 && campaign.arms.size() <= kMostCurves) return "arm";
  for (const Factor& factor : campaign.grid) {
    const std::size_t levels = factor.labels.size();
    if (factor.key.name != x && levels > 1 && levels <= kMostCurves) return factor.key.name;
  }
  return "";
}

}  // namespace

Json CurvesPart(const Campaign& campaign, const FinishedRuns& runs, const RowColumns& columns) {
  const Rows rows = UnchangedRows(runs.results, columns);
  Json figures = Json::array();
  const Figures& asked = campaign.figures;
  if (!asked.x.empty() && IsAxis(rows, columns, asked.x)) {
    AddFigures({asked.x, asked.curves, asked.panels, asked.measures}, rows, columns, figures);
  }
  for (const Factor& factor : campaign.grid) {
    const std::string& x = factor.key.name;
    if (x == asked.x || !IsAxis(rows, columns, x)) continue;
    AddFigures({x, CurvesFor(campaign, x), "", {kSuccess}}, rows, columns, figures);
  }
  return figures;
}

}  // namespace dockyard
