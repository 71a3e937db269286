#include "controller/motion/free_path.h"

#include <algorithm>

#include "controller/base/check.h"
#include "controller/motion/keep_in_view.h"

namespace dockyard {
namespace {

double ClearanceOf(const RoverPlan& rover, const PathDemands& demands,
                   const std::vector<Arc>& path) {
  if (!demands.grid) return Clearance(rover, path, demands.obstacles, demands.margin_m);
  const Obstacles near{demands.grid->Near(path, ReachOf(rover) + demands.margin_m),
                       demands.obstacles.polygons};
  return Clearance(rover, path, near, demands.margin_m);
}

}  // namespace

PathDemands WithGrid(PathDemands demands) {
  demands.grid = std::make_shared<const DiscGrid>(demands.obstacles.discs);
  return demands;
}

double MissingOf(const RoverPlan& rover, const PathDemands& demands, const std::vector<Arc>& path) {
  double missing_m = 0.0;
  if (demands.p_AT) {
    DOCKYARD_CHECK(rover.view);
    missing_m = std::max(missing_m, -SpareInView(*rover.view, path, *demands.p_AT));
  }
  const double clear_m = ClearanceOf(rover, demands, path);
  return std::max(missing_m, demands.margin_m - clear_m);
}

bool IsBlockedAtAnEnd(const RoverPlan& rover, const Pose2& X_RG, const PathDemands& demands) {
  for (const Pose2& X_AR : {Pose2{}, X_RG}) {
    const double clear_m = StandingClearance(rover, X_AR, demands.obstacles, demands.margin_m);
    if (clear_m < demands.margin_m) return true;
    if (demands.p_AT && SpareInView(*rover.view, {Arc{}}, Inverse(X_AR) * *demands.p_AT) < 0.0) {
      return true;
    }
  }
  return false;
}

}  // namespace dockyard
