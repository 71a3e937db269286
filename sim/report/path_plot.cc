#include <algorithm>
#include <cmath>

#include "sim/report/plan_area.h"
#include "sim/report/run_plots.h"

namespace dockyard {
namespace {

const Pen kTruth{"#222222", 2.0, "", 1.0};
const Pen kBelief{"#7b5ea7", 1.4, "2 3", 1.0};
const Pen kPlan{"#2a8f5c", 1.6, "6 3", 0.9};
const Pen kSeen{"#e07b00", 1.6, "", 1.0};
const Pen kRefused{"#c8321e", 1.4, "", 1.0};
constexpr const char* kImageFill = "#1f5fbf";

/// Poses of a series; those without a place are left out.
std::vector<Pose2> PosesOf(const Series& series) {
  std::vector<Pose2> poses;
  for (const char* name : {"x_m", "y_m", "heading_rad"}) {
    if (!series.contains(name)) return poses;
  }
  const auto located = series.find("located");
  const std::vector<double>& x = series.at("x_m");
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (located != series.end() && located->second[i] == 0.0) continue;
    poses.push_back({x[i], series.at("y_m")[i], series.at("heading_rad")[i]});
  }
  return poses;
}

/// Points nearer than a third of a pixel to the last one are left out, and those off the page.
void DrawWay(SvgDocument& svg, const PlotArea& area, const std::vector<Pose2>& poses,
             const char* css_class, const Pen& pen) {
  constexpr double kNear_px = 0.33;
  std::vector<Px> line;
  for (const Pose2& pose : poses) {
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !Inside(area, pose.x, pose.y)) continue;
    const Px at = area.At(pose.x, pose.y);
    if (!line.empty() && std::hypot(at.x - line.back().x, at.y - line.back().y) < kNear_px)
      continue;
    line.push_back(at);
  }
  svg.OpenGroup(css_class);
  svg.Polyline(line, pen);
  svg.CloseGroup();
}

void DrawTriangle(SvgDocument& svg, Px at, const std::string& fill, const Pen& pen) {
  svg.Polygon({{at.x, at.y - 6}, {at.x + 5, at.y + 4}, {at.x - 5, at.y + 4}}, fill, pen);
}

void DrawSightings(SvgDocument& svg, const PlotArea& area,
                   const std::vector<SightingSample>& sightings) {
  svg.OpenGroup("looks");
  for (const SightingSample& sample : sightings) {
    const Px place = area.At(sample.X_DR.x, sample.X_DR.y);
    const Pose2& seen = sample.X_DR_measured;
    if (!sample.report.accepted) {
      DrawTriangle(svg, place, "#ffffff", kRefused);
      continue;
    }
    DrawTriangle(svg, place, kImageFill, {kImageFill, 1.0, "", 1.0});
    if (!Inside(area, seen.x, seen.y)) continue;
    const Px measured = area.At(seen.x, seen.y);
    svg.Line(place, measured, {kSeen.color, 0.8, "", 0.8});
    svg.Line(measured,
             {measured.x + 16 * std::cos(seen.heading), measured.y - 16 * std::sin(seen.heading)},
             {kSeen.color, 1.2, "", 1.0});
    DrawCross(svg, measured, 4.0, kSeen);
  }
  svg.CloseGroup();
}

void DrawPathKey(SvgDocument& svg, Px at) {
  DrawLegend(
      svg, at,
      {{"true path", kTruth}, {"believed", kBelief}, {"planned", kPlan}, {"measured", kSeen}});
  at.x += 400;
  DrawTriangle(svg, {at.x, at.y - 4}, kImageFill, {kImageFill, 1.0, "", 1.0});
  svg.Text({at.x + 10, at.y}, "target measured", {11, "#333333"});
  DrawTriangle(svg, {at.x + 120, at.y - 4}, "#ffffff", kRefused);
  svg.Text({at.x + 130, at.y}, "not accepted", {11, "#333333"});
}

}  // namespace

std::string PathPlot(const std::string& title, const LoggedRun& run) {
  const std::vector<Pose2> truth = PosesOf(run.truth), belief = PosesOf(run.belief);
  std::vector<Pose2> shown = truth;
  for (const auto& plan : run.plans)
    shown.insert(shown.end(), plan.value.begin(), plan.value.end());
  const PlotArea area = PlanArea(shown);
  SvgDocument svg(std::max(area.width + 110.0, 740.0), area.height + 134.0, title);
  svg.Text({area.corner.x, 30}, title, {14, "#111111", Anchor::kStart, true});
  DrawPathKey(svg, {area.corner.x, 56});
  DrawPlanAxes(svg, area);
  for (const auto& plan : run.plans) DrawWay(svg, area, plan.value, "plan", kPlan);
  DrawWay(svg, area, belief, "believed", kBelief);
  DrawWay(svg, area, truth, "truth", kTruth);
  if (!truth.empty() && Inside(area, truth.front().x, truth.front().y)) {
    svg.Circle(area.At(truth.front().x, truth.front().y), 5.0, "#ffffff", kTruth);
  }
  DrawSightings(svg, area, run.sightings);
  return svg.Finish();
}

}  // namespace dockyard
