#include "sim/report/starts_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "controller/base/check.h"
#include "sim/report/plan_area.h"
#include "sim/report/rate_text.h"

namespace dockyard {
namespace {

constexpr const char* kBlue = "#1f5fbf";
constexpr const char* kRed = "#c8321e";
constexpr double kArrow_px = 26.0;
constexpr std::size_t kMostArrows = 2000, kMostNames = 60;

/// All runs that started in the same place: a campaign may repeat it.
struct Start {
  Pose2 X_DR;
  int runs = 0, successes = 0;
  const RunResult* first = nullptr;
  const RunResult* failed = nullptr;  // the first that did
};

/// In the order in which they first appear, to a millimetre and a milliradian. Those without a
/// place are left out.
std::vector<Start> StartsOf(const std::vector<RunResult>& rows, const std::vector<Pose2>& X_DR) {
  std::vector<Start> starts;
  std::map<std::array<double, 3>, std::size_t> places;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!std::isfinite(X_DR[i].x) || !std::isfinite(X_DR[i].y)) continue;
    const std::array<double, 3> key{std::round(1e3 * X_DR[i].x), std::round(1e3 * X_DR[i].y),
                                    std::round(1e3 * X_DR[i].heading)};
    const auto [place, fresh] = places.emplace(key, starts.size());
    if (fresh) starts.push_back({.X_DR = X_DR[i], .first = &rows[i]});
    Start& start = starts[place->second];
    ++start.runs;
    start.successes += rows[i].success;
    if (!rows[i].success && start.failed == nullptr) start.failed = &rows[i];
  }
  return starts;
}

void DrawStart(SvgDocument& svg, const PlotArea& area, const Start& start, bool arrow) {
  const bool all = start.successes == start.runs;
  const std::string color = all ? kBlue : kRed;
  const Px at = area.At(start.X_DR.x, start.X_DR.y);
  svg.OpenGroup("start", "run-" + std::to_string(start.first->run));
  if (arrow) {
    svg.Line(at,
             {at.x + kArrow_px * std::cos(start.X_DR.heading),
              at.y - kArrow_px * std::sin(start.X_DR.heading)},
             {color, 1.4, "", 0.9});
  }
  const double size = arrow ? 3.5 : 1.5;
  if (start.successes > 0) svg.Circle(at, size, kBlue, {kBlue, 0.5, "", 1.0});
  if (!all) DrawCross(svg, at, size + 1.0, {kRed, 1.8, "", 1.0});
  svg.CloseGroup();
}

std::string NameOf(const Start& start) {
  if (start.runs == 1) return std::to_string(start.failed->run) + " " + start.failed->outcome;
  return std::to_string(start.runs - start.successes) + " of " + std::to_string(start.runs) +
         " failed";
}

/// Beside each start with a failure; starts in one place below each other.
void DrawNames(SvgDocument& svg, const PlotArea& area, const std::vector<Start>& starts) {
  std::map<std::pair<double, double>, int> taken;
  for (const Start& start : starts) {
    if (start.failed == nullptr) continue;
    const Px at = area.At(start.X_DR.x, start.X_DR.y);
    const int line = taken[{std::round(at.x), std::round(at.y)}]++;
    svg.Text({at.x + 7, at.y + 12 + 11 * line}, NameOf(start), {10.0, kRed});
  }
}

void DrawKey(SvgDocument& svg, Px at, const std::string& word) {
  svg.Circle({at.x + 4, at.y - 4}, 3.5, kBlue, {kBlue, 0.5, "", 1.0});
  svg.Text({at.x + 13, at.y}, word);
  at.x += 20.0 + 7.0 * static_cast<double>(word.size());
  DrawCross(svg, {at.x + 12, at.y - 4}, 4.0, {kRed, 1.8, "", 1.0});
  svg.Text({at.x + 21, at.y}, "failed");
}

}  // namespace

std::string StartsPlot(const std::string& title, const std::string& word,
                       const std::vector<RunResult>& rows, const std::vector<Pose2>& X_DR) {
  DOCKYARD_CHECK(rows.size() == X_DR.size());
  const auto successes =
      std::count_if(rows.begin(), rows.end(), [](const RunResult& row) { return row.success; });
  const PlotArea area = PlanArea(X_DR);
  SvgDocument svg(std::max(area.width + 110.0, 560.0), area.height + 134.0, title);
  svg.Text({area.corner.x, 30},
           title + ": " + word + " " +
               RateText(static_cast<int>(successes), static_cast<int>(rows.size())),
           {16, "#111111", Anchor::kStart, true});
  DrawKey(svg, {area.corner.x, 56}, word);
  DrawPlanAxes(svg, area);
  std::vector<Start> starts = StartsOf(rows, X_DR);
  std::stable_partition(starts.begin(), starts.end(),
                        [](const Start& start) { return start.failed == nullptr; });
  for (const Start& start : starts) DrawStart(svg, area, start, starts.size() <= kMostArrows);
  const auto failing = std::count_if(starts.begin(), starts.end(),
                                     [](const Start& start) { return start.failed != nullptr; });
  if (static_cast<std::size_t>(failing) <= kMostNames) DrawNames(svg, area, starts);
  return svg.Finish();
}

}  // namespace dockyard
