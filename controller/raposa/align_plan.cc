#include "controller/raposa/align_plan.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

Eigen::Vector2d Along(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

}  // namespace

Eigen::Vector2d GuideInN(const GuidePlace& guide, double lever_m) {
  return Eigen::Vector2d(lever_m, 0.0) + guide.r_m * Along(-guide.bearing_rad);
}

Pose2 PoseOfN(const GuidePlace& guide, double lever_m) {
  const double heading = WrapPi(guide.alpha_rad + kPi + guide.bearing_rad);
  const Eigen::Vector2d p = guide.r_m * Along(guide.alpha_rad) - lever_m * Along(heading);
  return {p.x(), p.y(), heading};
}

AlignPlan PlanAlignment(const GuidePlace& guide, double standoff_m, double lever_m) {
  // In O the axis points out of the guide at pi - bearing - alpha: back along the line of sight,
  // less the robot's own angle about the pyramid.
  const double facing = -guide.bearing_rad - guide.alpha_rad;
  const Eigen::Vector2d end = GuideInN(guide, lever_m) - (standoff_m + lever_m) * Along(facing);
  AlignPlan plan;
  plan.beta_rad = std::atan2(end.y(), end.x());
  plan.way_m = end.norm();
  if (std::abs(plan.beta_rad) > 0.5 * kPi) {
    plan.beta_rad = WrapPi(plan.beta_rad + kPi);
    plan.way_m = -plan.way_m;
  }
  plan.phi_rad = WrapPi(facing - plan.beta_rad);
  plan.X_OE = {end.x(), end.y(), WrapPi(facing)};
  return plan;
}

double TurnOfBearing(double bearing_rad, double range_m, double lever_m) {
  const double share = std::clamp(lever_m * std::sin(bearing_rad) / range_m, -1.0, 1.0);
  return bearing_rad - std::asin(share);
}

}  // namespace dockyard::raposa
