// Paths of two and of three arcs that keep clear of obstacles and keep a target in view.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "controller/geometry/rover_plan.h"
#include "controller/motion/clearance.h"
#include "controller/motion/disc_grid.h"
#include "controller/motion/three_arcs.h"
#include "controller/motion/two_arcs.h"

namespace dockyard {

/// What a path must keep besides the limits of its arcs. Frame A: R at the start.
struct PathDemands {
  Obstacles obstacles{};
  double margin_m = 0.0;                  // from the outline to any obstacle
  std::optional<Eigen::Vector2d> p_AT{};  // to keep in the rover's view, which it must have
  /// Of the obstacles' discs. With it, each path is compared with the discs near it alone; all
  /// answers are the same. Worth it from a thousand on.
  std::shared_ptr<const DiscGrid> grid{};
};

/// The same demands with the grid.
PathDemands WithGrid(PathDemands demands);

/// 0 where the path keeps the demands. Else by how much [m] it must be moved, at least, to keep
/// them.
double MissingOf(const RoverPlan& rover, const PathDemands& demands, const std::vector<Arc>& path);

/// Whether no path keeps the demands, as the body does not where it stands at the start or the end.
bool IsBlockedAtAnEnd(const RoverPlan& rover, const Pose2& X_RG, const PathDemands& demands);

/// The pair of least cost, Eq. (14), to a pose of R within the limits and demands. None when there
/// is none among splits 1.5e-4 rad apart.
std::optional<ArcPair> CheapestFreePair(const RoverPlan& rover, const Pose2& X_RG,
                                        const ArcLimits& limits, const PathDemands& demands);

/// The shortest three arcs that a search finds: first arcs of even lengths and curvatures, the
/// pairs behind them, and the best one made shorter step by step. Two arcs where no first arc is
/// better.
std::optional<ArcTriple> ShortestFreeTriple(const RoverPlan& rover, const Pose2& X_RG,
                                            const ArcLimits& limits, const PathDemands& demands);

}  // namespace dockyard
