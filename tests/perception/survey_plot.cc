#include "perception/survey_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "sim/report/svg.h"
#include "sim/statistics/intervals.h"

namespace dockyard::axel {
namespace {

struct Value {
  double middle = 0.0;
  Interval interval;
  bool known = false;
};

/// 95 % interval of an rms of n values, by the normal approximation of chi (1 / sqrt(2 n)).
Value RmsValue(double rms, int n) {
  if (n < 3) return {};
  const double half = 1.96 * rms / std::sqrt(2.0 * n);
  return {rms, {std::max(0.0, rms - half), rms + half}, true};
}

Value RateValue(int successes, int trials) {
  if (trials < 1) return {};
  const Interval interval = ClopperPearson(successes, trials);
  return {100.0 * successes / trials, {100.0 * interval.low, 100.0 * interval.high}, true};
}

struct Panel {
  const char* label;
  double top;      // larger values are drawn at the top
  bool ours_only;  // the other pipeline's values are too large to show both
  std::function<Value(const SurveyTally&)> value;
};

std::vector<Panel> Panels() {
  const auto range = [](const SurveyTally& t) {
    return RmsValue(100.0 * t.named_range_rms_m(), t.named);
  };
  const auto heading = [](const SurveyTally& t) {
    return RmsValue(Degrees(t.named_heading_rms_rad()), t.named);
  };
  return {
      {"accepted and right, of in view [%]", 100.0, false,
       [](const SurveyTally& t) { return RateValue(t.accepted - t.wrong, t.in_view); }},
      {"centre error, rms [px]", 0.25, false,
       [](const SurveyTally& t) { return RmsValue(t.plain_rms_px(), t.plain); }},
      {"range error, rms [cm]", 80.0, false, range},
      {"heading error, rms [deg]", 12.0, false, heading},
      {"range error of dockyard, rms [cm]", 80.0, true, range},
      {"heading error of dockyard, rms [deg]", 12.0, true, heading},
  };
}

}  // namespace

std::string SurveyPlot(const std::string& title, const std::vector<SurveyCurve>& curves,
                       double r_max_m) {
  constexpr double kWidth = 430.0, kHeight = 230.0, kLeft = 70.0, kTop = 70.0, kGap = 80.0;
  SvgDocument svg(2 * kWidth + kLeft + 130.0, 3 * kHeight + kTop + 2 * kGap + 60.0, title);
  svg.Text({kLeft, 24.0}, title, {.size = 15.0, .bold = true});
  std::vector<std::pair<std::string, Pen>> legend;
  for (const SurveyCurve& curve : curves) {
    legend.push_back({curve.name, {curve.color, 1.8, curve.dash, 1.0}});
  }
  DrawLegend(svg, {kLeft, 46.0}, legend);
  int index = 0;
  for (const Panel& panel : Panels()) {
    double most = 0.0;
    for (const SurveyCurve& curve : curves) {
      if (panel.ours_only && !curve.ours) continue;
      for (int r = 0; r < r_max_m; ++r) {
        const Value value = panel.value(TallyOf(curve.scores, r, r + 1));
        if (value.known) most = std::max(most, value.interval.high);
      }
    }
    PlotArea area;
    const int column = index % 2, row = index / 2;
    area.corner = {kLeft + column * (kWidth + 80.0), kTop + row * (kHeight + kGap)};
    area.width = kWidth;
    area.height = kHeight;
    area.x = {0.0, r_max_m};
    area.y = {0.0, std::max(1e-3, std::min(1.05 * most, panel.top))};
    area.DrawAxes(svg, "range [m]", panel.label);
    const double top = area.y.high;
    for (const SurveyCurve& curve : curves) {
      if (panel.ours_only && !curve.ours) continue;
      std::vector<Px> points;
      for (int r = 0; r < r_max_m; ++r) {
        const Value value = panel.value(TallyOf(curve.scores, r, r + 1));
        if (!value.known) continue;
        const double shift = 0.04 * static_cast<double>(&curve - curves.data());
        points.push_back(area.At(r + 0.45 + shift, std::min(value.middle, top)));
        svg.Line(area.At(r + 0.45 + shift, std::min(value.interval.low, top)),
                 area.At(r + 0.45 + shift, std::min(value.interval.high, top)),
                 {curve.color, 1.0, "", 0.8});
        svg.Circle(points.back(), 2.5, curve.color, {curve.color, 1.0, "", 1.0});
      }
      svg.Polyline(points, {curve.color, 1.8, curve.dash, 1.0});
    }
    ++index;
  }
  return svg.Finish();
}

std::string SurveyCsv(const std::vector<SurveyCurve>& curves, double r_max_m) {
  std::string csv =
      "curve,r_low_m,r_high_m,in_view,found,found_low,found_high,accepted,accepted_low,accepted_"
      "high,"
      "wrong,wrong_high,"
      "range_rms_cm,range_low_cm,range_high_cm,heading_rms_deg,heading_low_deg,heading_high_deg,"
      "centre_rms_px,centre_marks,cut_rms_px,cut_marks,nees_mean\n";
  for (const SurveyCurve& curve : curves) {
    for (int r = 0; r < r_max_m; ++r) {
      const SurveyTally t = TallyOf(curve.scores, r, r + 1);
      if (t.in_view == 0) continue;
      const Interval found = ClopperPearson(t.found, t.in_view);
      const Interval accepted = ClopperPearson(t.accepted, t.in_view);
      const Interval wrong = ClopperPearson(t.wrong, t.accepted);
      const Value range = RmsValue(100.0 * t.named_range_rms_m(), t.named);
      const Value heading = RmsValue(Degrees(t.named_heading_rms_rad()), t.named);
      char line[400];
      std::snprintf(line, sizeof line,
                    "\"%s\",%d,%d,%d,%d,%.4f,%.4f,%d,%.4f,%.4f,%d,%.4f,%.3f,%.3f,%.3f,%.3f,%.3f,"
                    "%.3f,%.4f,%d,%.4f,%d,%.2f\n",
                    curve.name.c_str(), r, r + 1, t.in_view, t.found, found.low, found.high,
                    t.accepted, accepted.low, accepted.high, t.wrong, wrong.high, range.middle,
                    range.interval.low, range.interval.high, heading.middle, heading.interval.low,
                    heading.interval.high, t.plain_rms_px(), t.plain, t.cut_rms_px(), t.cut,
                    t.accepted > 0 ? t.nees / t.accepted : 0.0);
      csv += line;
    }
  }
  return csv;
}

}  // namespace dockyard::axel
