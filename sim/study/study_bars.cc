#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/base/check.h"
#include "sim/report/rate_text.h"
#include "sim/report/svg.h"
#include "sim/study/plot_labels.h"
#include "sim/study/study_results.h"

namespace dockyard {
namespace {

struct Bar {
  std::string label;
  double share_change = 0.0;    // of docked, 0 to 1
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

/// The measure of the second column of bars: the first of the study's plot that is no share.
std::optional<Column> SecondMeasure(const Study& study, const std::vector<Column>& measured) {
  for (const std::string& name : study.measures) {
    if (name == "docked") continue;
    const auto found = std::find_if(measured.begin(), measured.end(),
                                    [&](const Column& each) { return each.name == name; });
    DOCKYARD_CHECK(found != measured.end());
    return *found;
  }
  return std::nullopt;
}

std::vector<const StudyRow*> RowsChanged(const Study& study, const std::vector<StudyRow>& rows,
                                         int changed, int level) {
  std::vector<const StudyRow*> found;
  for (const StudyRow& row : rows) {
    const StudyPoint& point = study.points[static_cast<std::size_t>(row.point)];
    if (point.changed == changed && point.changed_level == level) found.push_back(&row);
  }
  return found;
}

std::vector<BarGroup> BarGroups(const Study& study, const std::vector<Column>& measured,
                                const std::optional<Column>& second,
                                const std::vector<StudyRow>& rows) {
  const auto mean = [&](const std::string& name, const std::vector<const StudyRow*>& of) {
    return SpreadOf(measured, name, of).mean;
  };
  const auto base = RowsChanged(study, rows, -1, -1);
  std::vector<BarGroup> groups;
  for (std::size_t i = 0; i < study.one_at_a_time.size(); ++i) {
    const StudyFactor& factor = study.one_at_a_time[i];
    BarGroup group{factor.key, {}};
    for (std::size_t level = 0; level < factor.values.size(); ++level) {
      const auto there = RowsChanged(study, rows, static_cast<int>(i), static_cast<int>(level));
      if (there.empty()) continue;
      group.bars.push_back({factor.labels[level], mean("docked", there) - mean("docked", base),
                            second ? mean(second->name, there) - mean(second->name, base) : 0.0});
    }
    if (!group.bars.empty()) groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const BarGroup& a, const BarGroup& b) { return a.reach() > b.reach(); });
  return groups;
}

constexpr double kLeft = 330, kTop = 84, kWide = 260, kGap = 50, kBarPx = 11, kGroupGap = 7;

double HeightOf(const std::vector<BarGroup>& groups) {
  double high = 0.0;
  for (const BarGroup& group : groups) {
    high += kBarPx * static_cast<double>(group.bars.size()) + kGroupGap;
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
      svg.Rect({std::min(zero, end), top + 1}, std::max(0.8, std::abs(end - zero)), kBarPx - 2,
               StudyColor(color++));
      top += kBarPx;
    }
    top += kGroupGap;
  }
}

void DrawNames(SvgDocument& svg, const std::vector<BarGroup>& groups) {
  double top = kTop;
  for (const BarGroup& group : groups) {
    for (const Bar& bar : group.bars) {
      svg.Text({kLeft - 8, top + kBarPx - 2}, group.key + " = " + bar.label,
               {10, "#333333", Anchor::kEnd});
      top += kBarPx;
    }
    top += kGroupGap;
  }
}

}  // namespace

std::string StudyBars(const Study& study, const RowColumns& columns,
                      const std::vector<StudyRow>& rows) {
  const std::vector<Column> measured = StudyColumns(columns);
  const std::optional<Column> second = SecondMeasure(study, measured);
  const std::vector<BarGroup> groups = BarGroups(study, measured, second, rows);
  if (groups.empty()) return "";
  SvgDocument svg(kLeft + (second ? 2 : 1) * (kWide + kGap), kTop + HeightOf(groups) + 60,
                  study.name);
  svg.Text({16, 26}, study.name + ": one key changed at a time",
           {15, "#111111", Anchor::kStart, true});
  const auto base = RowsChanged(study, rows, -1, -1);
  const Spread docked = SpreadOf(measured, "docked", base);
  std::string unchanged =
      "unchanged: " +
      BriefRate(static_cast<int>(std::lround(docked.mean * docked.count)), docked.count);
  if (second) {
    unchanged += ", mean " + AxisLabel(*second) + " " +
                 BriefNumber(SpreadOf(measured, second->name, base).mean);
  }
  svg.Text({16, 48}, unchanged, {12, "#333333"});
  const PlotArea share = BarArea(0, groups, &Bar::share_change);
  DrawScale(svg, share, "change of the docked share");
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
