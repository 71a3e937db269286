#include <algorithm>
#include <cmath>

#include "sim/report/plot_labels.h"
#include "sim/report/rate_text.h"
#include "sim/report/sensitivity.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostDraws = 30;
constexpr double kLeft = 300, kTop = 74, kEtaWide = 170, kGap = 30, kWide = 340,
                 kRow = 24;  // [px]
constexpr const char *kGrey = "#8a8f98", *kBlue = "#1f5fa8", *kOrange = "#d9772b";

/// The draws whose effect on success is known.
std::vector<const DrawEffect*> Shown(const Sensitivity& arm) {
  std::vector<const DrawEffect*> shown;
  for (const DrawEffect& draw : arm.measures[0].draws) {
    if (!std::isnan(draw.eta) && shown.size() < kMostDraws) shown.push_back(&draw);
  }
  return shown;
}

double HeightOf(std::size_t draws) { return kRow * static_cast<double>(draws); }

PlotArea Area(double left, double width, double top, std::size_t draws, const DataRange& x) {
  return {{left, top}, width, HeightOf(draws), x, {0.0, 1.0}};
}

/// Grid lines over zero and the ticks, the title below.
void DrawScale(SvgDocument& svg, const PlotArea& area, const std::string& title) {
  const double step = NiceStep(area.x.span(), 4), top = area.corner.y, bottom = top + area.height;
  for (double i = std::ceil(area.x.low / step - 1e-9); i * step <= area.x.high + 1e-9; ++i) {
    const double x = area.At(i * step, 0.0).x;
    svg.Line({x, top}, {x, bottom}, {i == 0 ? "#444444" : "#e0e0e0", 1.0, "", 1.0});
    svg.Text({x, bottom + 15}, TickText(i * step, step), {11, "#444444", Anchor::kMiddle});
  }
  svg.Text({area.corner.x + area.width / 2, bottom + 33}, title, {12, "#222222", Anchor::kMiddle});
}

/// A line over the interval with short ends.
void DrawInterval(SvgDocument& svg, const PlotArea& area, const Interval& interval, double y,
                  const std::string& color) {
  if (std::isnan(interval.low)) return;
  const double low = area.At(interval.low, 0.0).x, high = area.At(interval.high, 0.0).x;
  const Pen pen{color, 1.4, "", 1.0};
  svg.Line({low, y}, {high, y}, pen);
  for (const double x : {low, high}) svg.Line({x, y - 3}, {x, y + 3}, pen);
}

void DrawCorrelations(SvgDocument& svg, const PlotArea& area, const DrawEffect& draw, double top) {
  const Estimate &whole = draw.rank_correlation, &partial = draw.partial;
  if (!std::isnan(whole.value)) {
    const double zero = area.At(0.0, 0.0).x, end = area.At(whole.value, 0.0).x;
    svg.Rect({std::min(zero, end), top + 3}, std::max(0.8, std::abs(end - zero)), 10, kBlue, 0.55);
    DrawInterval(svg, area, whole.interval, top + 8, "#12355b");
  }
  if (!std::isnan(partial.value)) {
    const double y = top + 18;
    svg.Circle({area.At(partial.value, 0.0).x, y}, 2.8, kOrange, {kOrange, 0.5, "", 1.0});
    DrawInterval(svg, area, partial.interval, y, kOrange);
  }
}

/// The rates of a draw of words, "loose 60 % (36-81)", which have no order; as many as fit in.
void DrawRates(SvgDocument& svg, const PlotArea& area, const Sensitivity& arm,
               const std::string& label, double top) {
  constexpr std::size_t kFits = 66;  // letters of about 5 px
  std::string text;
  for (const LevelRate& rate : arm.rates) {
    if (rate.label != label) continue;
    const std::string more =
        (text.empty() ? "" : ", ") + rate.word + " " + ShortRate(rate.successes, rate.runs);
    if (text.size() + more.size() > kFits) {
      text += " ...";
      break;
    }
    text += more;
  }
  svg.Text({area.corner.x + 4, top + 15}, text, {10, "#333333"});
}

DataRange CorrelationRange(const std::vector<const DrawEffect*>& draws) {
  double most = 0.1;
  for (const DrawEffect* draw : draws) {
    for (const Estimate* each : {&draw->rank_correlation, &draw->partial}) {
      for (const double x : {each->value, each->interval.low, each->interval.high}) {
        if (!std::isnan(x)) most = std::max(most, std::abs(x));
      }
    }
  }
  return {-1.05 * most, 1.05 * most};
}

void DrawArm(SvgDocument& svg, const Sensitivity& arm, double top) {
  const std::vector<const DrawEffect*> draws = Shown(arm);
  double most = 0.1;
  for (const DrawEffect* draw : draws) most = std::max(most, draw->eta);
  const PlotArea eta = Area(kLeft, kEtaWide, top, draws.size(), {0.0, 1.05 * most});
  const PlotArea area =
      Area(kLeft + kEtaWide + kGap, kWide, top, draws.size(), CorrelationRange(draws));
  DrawScale(svg, eta, "eta, of any shape");
  DrawScale(svg, area, "rank correlation");
  if (!arm.arm.empty()) {
    svg.Text({kLeft - 8, top - 6}, "arm " + arm.arm, {12, "#111111", Anchor::kEnd, true});
  }
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const DrawEffect& draw = *draws[i];
    const double row = top + kRow * static_cast<double>(i);
    svg.Text({kLeft - 8, row + 15}, draw.label, {11, "#222222", Anchor::kEnd});
    svg.Rect({kLeft, row + 4}, std::max(0.8, eta.At(draw.eta, 0.0).x - kLeft), 14, kGrey);
    if (draw.words) {
      DrawRates(svg, area, arm, draw.label, row);
    } else {
      DrawCorrelations(svg, area, draw, row);
    }
  }
}

}  // namespace

std::string SensitivityPlot(const std::string& title, const std::vector<Sensitivity>& found) {
  constexpr double kBelow = 66;  // ticks, title, and room for the next arm's name
  double height = kTop;
  for (const Sensitivity& arm : found) {
    if (!Shown(arm).empty()) height += HeightOf(Shown(arm).size()) + kBelow;
  }
  if (height == kTop) return "";
  SvgDocument svg(kLeft + kEtaWide + kGap + kWide + 30, height, title);
  svg.Text({16, 26}, title + ": what success depends on", {15, "#111111", Anchor::kStart, true});
  DrawLegend(svg, {kLeft, 50},
             {{"eta", {kGrey, 8, "", 1.0}},
              {"rank correlation, 95 %", {kBlue, 8, "", 0.55}},
              {"partial, 95 %", {kOrange, 2, "", 1.0}}});
  double top = kTop;
  for (const Sensitivity& arm : found) {
    if (Shown(arm).empty()) continue;
    DrawArm(svg, arm, top);
    top += HeightOf(Shown(arm).size()) + kBelow;
  }
  return svg.Finish();
}

}  // namespace dockyard
