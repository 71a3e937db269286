#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/base/check.h"
#include "sim/log/results.h"
#include "sim/report/plot_labels.h"
#include "sim/report/points.h"
#include "sim/report/rate_text.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

struct Bar {
  std::string label;
  double share_change = 0.0;    // of successes, 0 to 1
  double measure_change = 0.0;  // of the measure's mean, in its unit
};

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

/// The measure of the second column of bars: the first that is no share.
std::optional<Column> SecondMeasure(const std::vector<std::string>& measures,
                                    const RowColumns& columns) {
  for (const std::string& name : measures) {
    if (name == kSuccess) continue;
    const std::vector<Column> summed = SummedColumns(columns);
    const auto found = std::find_if(summed.begin(), summed.end(),
                                    [&](const Column& each) { return each.name == name; });
    DOCKYARD_CHECK(found != summed.end());
    return *found;
  }
  return std::nullopt;
}

/// Rows in which a key was changed alone, in the order of the keys and their values.
struct Change {
  std::string key, to;
  Rows rows;
};

std::vector<Change> ChangesOf(const RowColumns& columns, const std::vector<RunResult>& rows) {
  std::vector<Change> changes;
  const auto& labels = columns.labels;
  if (std::find(labels.begin(), labels.end(), "changed") == labels.end()) return changes;
  for (const RunResult& row : rows) {
    const std::string &key = LabelOf(row, columns, "changed"),
                      &to = LabelOf(row, columns, "changed_to");
    if (key.empty()) continue;
    const auto known = std::find_if(changes.begin(), changes.end(), [&](const Change& each) {
      return each.key == key && each.to == to;
    });
    if (known == changes.end()) {
      changes.push_back({key, to, {&row}});
    } else {
      known->rows.push_back(&row);
    }
  }
  return changes;
}

std::vector<BarGroup> BarGroups(const RowColumns& columns, const std::optional<Column>& second,
                                const std::vector<RunResult>& rows) {
  const auto mean = [&](const std::string& name, const Rows& of) {
    return SpreadOf(columns, name, of).mean;
  };
  const Rows base = UnchangedRows(rows, columns);
  std::vector<BarGroup> groups;
  for (const Change& change : ChangesOf(columns, rows)) {
    if (groups.empty() || groups.back().key != change.key) groups.push_back({change.key, {}});
    groups.back().bars.push_back(
        {change.to, mean(kSuccess, change.rows) - mean(kSuccess, base),
         second ? mean(second->name, change.rows) - mean(second->name, base) : 0.0});
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const BarGroup& a, const BarGroup& b) { return a.reach() > b.reach(); });
  return groups;
}

constexpr double kLeft = 330, kTop = 84, kWide = 260, kGap = 50, kBar_px = 11, kGroupGap = 7;

double HeightOf(const std::vector<BarGroup>& groups) {
  double high = 0.0;
  for (const BarGroup& group : groups) {
    high += kBar_px * static_cast<double>(group.bars.size()) + kGroupGap;
  }
  return high;
}

PlotArea BarArea(int column, const std::vector<BarGroup>& groups, double Bar::*change) {
  // The range holds zero and is never empty.
  DataRange range = change == &Bar::share_change ? DataRange{-0.05, 0.05} : DataRange{0.0, 0.0};
  for (const BarGroup& group : groups) {
    for (const Bar& bar : group.bars) range.Hold(bar.*change);
  }
  if (range.span() <= 0.0) range = {-1.0, 1.0};
  const double pad = 0.05 * range.span();
  return {{kLeft + column * (kWide + kGap), kTop},
          kWide,
          HeightOf(groups),
          {range.low - pad, range.high + pad},
          {0.0, 1.0}};
}

void DrawScale(SvgDocument& svg, const PlotArea& area, const std::string& title) {
  const double step = NiceStep(area.x.span(), 4), bottom = kTop + area.height;
  for (double i = std::ceil(area.x.low / step); i * step <= area.x.high; ++i) {
    const Px at = area.At(i * step, 0.0);
    svg.Line({at.x, kTop}, {at.x, bottom}, {i == 0 ? "#444444" : "#e0e0e0", 1.0, "", 1.0});
    svg.Text({at.x, bottom + 16}, TickText(i * step, step), {11, "#444444", Anchor::kMiddle});
  }
  svg.Text({area.corner.x + kWide / 2, bottom + 36}, title, {12, "#222222", Anchor::kMiddle});
}

void DrawBars(SvgDocument& svg, const PlotArea& area, const std::vector<BarGroup>& groups,
              double Bar::*change) {
  double top = kTop;
  for (const BarGroup& group : groups) {
    std::size_t color = 0;
    for (const Bar& bar : group.bars) {
      const double zero = area.At(0.0, 0.0).x, end = area.At(bar.*change, 0.0).x;
      svg.Rect({std::min(zero, end), top + 1}, std::max(0.8, std::abs(end - zero)), kBar_px - 2,
               CurveColor(color++));
      top += kBar_px;
    }
    top += kGroupGap;
  }
}

void DrawNames(SvgDocument& svg, const std::vector<BarGroup>& groups) {
  double top = kTop;
  for (const BarGroup& group : groups) {
    for (const Bar& bar : group.bars) {
      svg.Text({kLeft - 8, top + kBar_px - 2}, group.key + " = " + bar.label,
               {10, "#333333", Anchor::kEnd});
      top += kBar_px;
    }
    top += kGroupGap;
  }
}

}  // namespace

std::string BarsPlot(const std::string& title, const std::vector<std::string>& measures,
                     const RowColumns& columns, const std::vector<RunResult>& rows) {
  const std::optional<Column> second = SecondMeasure(measures, columns);
  const std::vector<BarGroup> groups = BarGroups(columns, second, rows);
  if (groups.empty()) return "";
  SvgDocument svg(kLeft + (second ? 2 : 1) * (kWide + kGap), kTop + HeightOf(groups) + 60, title);
  svg.Text({16, 26}, title + ": one key changed at a time", {15, "#111111", Anchor::kStart, true});
  const Rows base = UnchangedRows(rows, columns);
  const Spread share_now = SpreadOf(columns, kSuccess, base);
  std::string unchanged =
      "unchanged: " + SuccessWord(columns, rows) + " " +
      RateText(static_cast<int>(std::lround(share_now.mean * share_now.count)), share_now.count);
  if (second) {
    unchanged += ", mean " + AxisLabel(*second) + " " +
                 BriefNumber(SpreadOf(columns, second->name, base).mean);
  }
  svg.Text({16, 48}, unchanged, {12, "#333333"});
  const PlotArea share = BarArea(0, groups, &Bar::share_change);
  DrawScale(svg, share, "change of the share of successes");
  if (second) {
    const PlotArea area = BarArea(1, groups, &Bar::measure_change);
    DrawScale(svg, area, "change of the mean " + AxisLabel(*second));
    DrawBars(svg, area, groups, &Bar::measure_change);
  }
  DrawNames(svg, groups);
  DrawBars(svg, share, groups, &Bar::share_change);
  return svg.Finish();
}

}  // namespace dockyard
