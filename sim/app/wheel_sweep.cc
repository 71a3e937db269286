#include "sim/app/wheel_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

constexpr const char* kHead =
    "load_N,beta_deg,slip,Fx_N,Fy_N,Fz_N,torque_Nm,sinkage_m,Fx_rms_N,height_rms_m,travel_m,steps,"
    "steady,warnings";

std::string RowText(const WheelRow& row) {
  const SingleWheelResult& r = row.result;
  char text[320];
  std::snprintf(text, sizeof(text), "%g,%g,%g,%.5g,%.5g,%.5g,%.5g,%.5g,%.3g,%.3g,%.4g,%ld,%d,%zu",
                row.load_n, row.beta_deg, row.slip, r.ahead_n, r.side_n, r.up_n, r.torque_nm,
                r.sinkage_m, r.ahead_rms_n, r.height_rms_m, r.travel_m, r.steps,
                row.holds() ? 1 : 0, row.warnings.size());
  return text;
}

Json RowObject(const WheelRow& row) {
  const SingleWheelResult& r = row.result;
  return {{"load_N", row.load_n},      {"beta_deg", row.beta_deg},
          {"slip", row.slip},          {"Fx_N", r.ahead_n},
          {"Fy_N", r.side_n},          {"Fz_N", r.up_n},
          {"torque_Nm", r.torque_nm},  {"sinkage_m", r.sinkage_m},
          {"Fx_rms_N", r.ahead_rms_n}, {"height_rms_m", r.height_rms_m},
          {"travel_m", r.travel_m},    {"steps", r.steps},
          {"steady", row.holds()},     {"warnings", row.warnings}};
}

struct Point {
  double slip = 0.0, value = 0.0;
};

/// A curve of the model with the rows measured at its side slip.
struct Curve {
  double load_n = 0.0, beta_deg = 0.0;
  std::vector<Point> model, measured;
};

// Side slips of a table are nominal: closer ones are the same [deg].
constexpr double kSameSideSlip_deg = 0.5;

template <typename OfModel, typename OfMeasured>
std::vector<Curve> MakeCurves(const std::vector<WheelRow>& table,
                              const std::vector<MeasuredRow>& measured, const OfModel& of_model,
                              const OfMeasured& of_measured) {
  std::map<std::pair<double, double>, Curve> curves;
  for (const WheelRow& row : table) {
    Curve& curve = curves[{row.load_n, row.beta_deg}];
    curve.load_n = row.load_n;
    curve.beta_deg = row.beta_deg;
    curve.model.push_back({row.slip, of_model(row)});
  }
  std::vector<Curve> list;
  for (auto& [key, curve] : curves) {
    std::sort(curve.model.begin(), curve.model.end(),
              [](const Point& a, const Point& b) { return a.slip < b.slip; });
    for (const MeasuredRow& row : measured) {
      if (std::fabs(row.beta_deg - curve.beta_deg) > kSameSideSlip_deg) continue;
      const double value = of_measured(row);
      if (std::isfinite(value)) curve.measured.push_back({row.slip, value});
    }
    list.push_back(std::move(curve));
  }
  return list;
}

void DrawSquare(SvgDocument& svg, Px at, const std::string& colour) {
  constexpr double kHalf = 4.0;
  const double x = at.x, y = at.y;
  svg.Polygon({{x - kHalf, y - kHalf},
               {x + kHalf, y - kHalf},
               {x + kHalf, y + kHalf},
               {x - kHalf, y + kHalf}},
              "none", {colour, 1.6, "", 1.0});
}

std::string Plot(const std::vector<Curve>& curves, const std::string& title,
                 const std::string& label) {
  constexpr std::array<const char*, 6> kColours{"#1f5fbf", "#c8321e", "#2a8f5c",
                                                "#8a4fb0", "#b07a1e", "#444444"};
  SvgDocument svg(720, 470, title);
  PlotArea area;
  area.corner = {86, 66};
  area.width = 600;
  area.height = 340;
  area.x = area.y = DataRange::Nothing();
  bool any_measured = false;
  for (const Curve& curve : curves) {
    for (const auto* points : {&curve.model, &curve.measured}) {
      for (const Point& point : *points) {
        area.x.Hold(point.slip);
        area.y.Hold(point.value);
      }
    }
    any_measured = any_measured || !curve.measured.empty();
  }
  area.y.Hold(0.0);
  const double x_margin = std::max(0.05, 0.04 * area.x.span());
  const double y_margin = std::max(0.02, 0.06 * area.y.span());
  area.x = {area.x.low - x_margin, area.x.high + x_margin};
  area.y = {area.y.low - y_margin, area.y.high + y_margin};
  svg.Text({86, 26}, title + (any_measured ? "; squares: measured" : ""),
           {.size = 15.0, .bold = true});
  area.DrawAxes(svg, "slip", label);
  std::vector<std::pair<std::string, Pen>> legend;
  for (const Curve& curve : curves) {
    const Pen pen{kColours[legend.size() % kColours.size()], 1.8, "", 1.0};
    std::vector<Px> points;
    for (const Point& point : curve.model) points.push_back(area.At(point.slip, point.value));
    svg.Polyline(points, pen);
    for (const Px& point : points) svg.Circle(point, 3.0, pen.color, pen);
    for (const Point& point : curve.measured) {
      DrawSquare(svg, area.At(point.slip, point.value), pen.color);
    }
    legend.push_back(
        {TickText(curve.beta_deg, 1.0) + " deg, " + TickText(curve.load_n, 1.0) + " N", pen});
  }
  DrawLegend(svg, {area.corner.x + 4, area.corner.y - 8}, legend);
  return svg.Finish();
}

}  // namespace

void PrintWheelResult(const WheelRow& row) {
  const SingleWheelResult& r = row.result;
  std::printf("Fx_N       %.4g\nFy_N       %.4g\nFz_N       %.4g\ntorque_Nm  %.4g\n", r.ahead_n,
              r.side_n, r.up_n, r.torque_nm);
  std::printf("sinkage_m  %.4g\nsteps      %ld\n", r.sinkage_m, r.steps);
}

void PrintWheelRow(const WheelRow& row, bool with_head) {
  if (with_head) std::printf("%s\n", kHead);
  std::printf("%s\n", RowText(row).c_str());
}

std::string WheelJson(const std::vector<WheelRow>& table, bool as_list) {
  if (!as_list) return RowObject(table.front()).dump(1);
  Json list = Json::array();
  for (const WheelRow& row : table) list.push_back(RowObject(row));
  return list.dump(1);
}

std::string DrawbarPlot(const std::vector<WheelRow>& table,
                        const std::vector<MeasuredRow>& measured) {
  const auto curves = MakeCurves(
      table, measured, [](const WheelRow& row) { return row.result.ahead_n / row.load_n; },
      [](const MeasuredRow& row) { return row.ahead_n / row.load_n; });
  return Plot(curves, "Drawbar over the load", "Fx / load");
}

std::string SinkagePlot(const std::vector<WheelRow>& table,
                        const std::vector<MeasuredRow>& measured) {
  const auto curves = MakeCurves(
      table, measured, [](const WheelRow& row) { return 1e3 * row.result.sinkage_m; },
      [](const MeasuredRow& row) { return 1e3 * row.sinkage_m; });
  return Plot(curves, "Sinkage", "sinkage [mm]");
}

void WriteWheelSweep(const std::vector<WheelRow>& table, const std::vector<MeasuredRow>& measured,
                     const std::filesystem::path& folder) {
  std::string csv = std::string(kHead) + "\n";
  for (const WheelRow& row : table) csv += RowText(row) + "\n";
  WriteWhole(folder / "sweep.csv", csv);
  WriteWhole(folder / "drawbar.svg", DrawbarPlot(table, measured));
  WriteWhole(folder / "sinkage.svg", SinkagePlot(table, measured));
}

}  // namespace dockyard
