// Three arcs to a pose: a first arc to a place from where two arcs go on (two_arcs.h). A back-off
// before a pair is a case of it. Two arcs that may not turn in place miss some poses near by and
// some headings; three reach all of them.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "controller/motion/two_arcs.h"

namespace dockyard {

using ArcTriple = std::array<Arc, 3>;

/// First arcs to try: none (no length), and lengths of step_m to longest_m either way as the limits
/// let, straight and in `curvatures` even steps up to the least radius on either side; without a
/// least radius up to a half circle.
std::vector<Arc> FirstArcs(const ArcLimits& limits, double step_m, double longest_m,
                           int curvatures);

/// For each first arc that `wants` lets through, calls look for the pairs of ForEachPair from its
/// end on. Behind a first arc backwards the course turns by cusp_turn_rad: a rover that drifts
/// sideways keeps another course forwards than backwards.
void ForEachTriple(const Pose2& X_RG, const std::vector<Arc>& firsts, const ArcLimits& limits,
                   int splits, const std::function<bool(const Arc&)>& wants,
                   const std::function<void(const ArcTriple&)>& look, double cusp_turn_rad = 0.0);

}  // namespace dockyard
