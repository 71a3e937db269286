#include "controller/motion/three_arcs.h"

#include "controller/base/check.h"

namespace dockyard {

std::vector<Arc> FirstArcs(const ArcLimits& limits, double step_m, double longest_m,
                           int curvatures) {
  DOCKYARD_CHECK(step_m > 0.0 && curvatures >= 0);
  std::vector<Arc> arcs{{}};
  const auto Add = [&](const Arc& arc) {
    if (Keeps(arc, limits)) arcs.push_back(arc);
  };
  const int steps = static_cast<int>(longest_m / step_m + 1e-9);
  for (int i = 1; i <= steps; ++i) {
    for (const double length_m : {i * step_m, -i * step_m}) {
      Add({length_m, 0.0});
      for (int j = 1; j <= curvatures; ++j) {
        const double radius_m = limits.least_radius_m * curvatures / j;
        const double turn = radius_m > 0.0 ? i * step_m / radius_m : kPi * j / curvatures;
        if (turn > kPi) break;
        Add({length_m, turn});
        Add({length_m, -turn});
      }
    }
  }
  return arcs;
}

void ForEachTriple(const Pose2& X_RG, const std::vector<Arc>& firsts, const ArcLimits& limits,
                   int splits, const std::function<bool(const Arc&)>& wants,
                   const std::function<void(const ArcTriple&)>& look, double cusp_turn_rad) {
  for (const Arc& first : firsts) {
    if (!wants(first)) continue;
    const Pose2 turned{0.0, 0.0, first.length_m < 0.0 ? cusp_turn_rad : 0.0};
    ForEachPair(Inverse(Advance({}, first) * turned) * X_RG, limits, splits,
                [&](const ArcPair& pair) {
                  look({first, pair[0], pair[1]});
                });
  }
}

}  // namespace dockyard
