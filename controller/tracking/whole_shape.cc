#include "controller/tracking/whole_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr double kSharpest = 0.125;  // of a cell, where the refinement ends

// How well the shape fits at a pose; without a value where too little of it is seen.
struct Fit {
  double misfit2 = std::numeric_limits<double>::infinity();  // mean square over the sigmas
  double rise_m = 0.0;                                       // of the new heights over the shape's
  bool seen = false;
};

Fit FitAt(const HeightPatch& shape, const ElevationMap& map, const Pose2& X_ET,
          double least_share) {
  double weight = 0.0, first = 0.0, second = 0.0;
  int seen = 0;
  for (const HeightPatch::Cell& cell : shape.cells) {
    const auto at = Bilinear(map, X_ET * cell.p_T);
    if (!at) continue;
    const double w = 1.0 / (at->variance_m2 + cell.variance_m2);
    const double rise = at->height_m - cell.height_m;
    weight += w;
    first += w * rise;
    second += w * rise * rise;
    ++seen;
  }
  if (seen < least_share * shape.places || seen < 4) return {};
  return {std::max(0.0, second - first * first / weight) / seen, first / weight, true};
}

struct Candidate {
  Pose2 X_ET;
  Fit fit;
};

Pose2 Moved(const Pose2& from, double x, double y, double yaw) {
  return {from.x + x, from.y + y, WrapPi(from.heading + yaw)};
}

// Steps in x, y and yaw that fit better, ever smaller.
Candidate Sharpened(const HeightPatch& shape, const ElevationMap& map, Candidate best,
                    const WholeShapeSettings& with) {
  double step_m = 0.5 * map.cell_m, step_rad = 0.5 * with.yaw_step_rad;
  while (step_m > kSharpest * map.cell_m) {
    bool better = false;
    for (const auto& [x, y, yaw] : {std::tuple{step_m, 0.0, 0.0},
                                    {-step_m, 0.0, 0.0},
                                    {0.0, step_m, 0.0},
                                    {0.0, -step_m, 0.0},
                                    {0.0, 0.0, step_rad},
                                    {0.0, 0.0, -step_rad}}) {
      const Pose2 X_ET = Moved(best.X_ET, x, y, yaw);
      const Fit fit = FitAt(shape, map, X_ET, with.least_share);
      if (fit.misfit2 >= best.fit.misfit2) continue;
      best = {X_ET, fit};
      better = true;
    }
    if (better) continue;
    step_m *= 0.5;
    step_rad *= 0.5;
  }
  return best;
}

}  // namespace

HeightPatch ShapeAbout(const ElevationMap& map, const Pose2& X_ET,
                       const WholeShapeSettings& settings) {
  return PatchOf(map, X_ET, settings.half_m, settings.step_m);
}

TrackedShape FindShape(const HeightPatch& shape, const ElevationMap& map,
                       const Pose2& X_ET_predicted, const WholeShapeSettings& with) {
  TrackedShape found;
  if (shape.Relief() < with.least_relief_m) {
    found.verdict = TrackVerdict::kFlat;
    return found;
  }
  const int steps = static_cast<int>(std::ceil(with.window_m / map.cell_m));
  const int turns = static_cast<int>(std::ceil(with.yaw_rad / with.yaw_step_rad));
  std::vector<Candidate> all;
  for (int turn = -turns; turn <= turns; ++turn) {
    for (int iy = -steps; iy <= steps; ++iy) {
      for (int ix = -steps; ix <= steps; ++ix) {
        const Pose2 X_ET =
            Moved(X_ET_predicted, ix * map.cell_m, iy * map.cell_m, turn * with.yaw_step_rad);
        const Fit fit = FitAt(shape, map, X_ET, with.least_share);
        if (fit.seen) all.push_back({X_ET, fit});
      }
    }
  }
  if (all.empty()) return found;
  const auto Worse = [](const Candidate& a, const Candidate& b) {
    return a.fit.misfit2 < b.fit.misfit2;
  };
  const Candidate best =
      Sharpened(shape, map, *std::min_element(all.begin(), all.end(), Worse), with);
  double second2 = std::numeric_limits<double>::infinity();
  for (const Candidate& other : all) {
    const double away_m = std::hypot(other.X_ET.x - best.X_ET.x, other.X_ET.y - best.X_ET.y);
    if (away_m >= with.apart_m) second2 = std::min(second2, other.fit.misfit2);
  }
  found.X_ET = best.X_ET;
  found.misfit = std::sqrt(best.fit.misfit2);
  found.ratio = std::sqrt(second2 / std::max(best.fit.misfit2, 1e-12));
  const auto height = Bilinear(map, {best.X_ET.x, best.X_ET.y});
  found.height_m = height ? height->height_m : best.fit.rise_m;
  found.verdict = found.misfit > with.most_misfit  ? TrackVerdict::kMisfit
                  : found.ratio < with.least_ratio ? TrackVerdict::kAmbiguous
                                                   : TrackVerdict::kFound;
  return found;
}

}  // namespace dockyard
