#include "controller/axel/plan_geometry.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {

PlanGeometry PlanGeometryOf(const Nominal& nominal) {
  PlanGeometry geometry;
  geometry.arm_m = nominal.arm_length_m;
  geometry.mating_depth_m = nominal.mating_depth_m;
  const Camera& lens = nominal.rig.left;
  const Eigen::Vector2d centre = lens.centre_px();
  const double narrow = std::min(centre.x() + 0.5, lens.width - 0.5 - centre.x());
  const Eigen::Vector3d edge = lens.Direction({centre.x() + narrow, centre.y()});
  geometry.half_view_rad = std::atan2(edge.x(), edge.z());
  geometry.board_half_width_m = 0.5 * nominal.board.width_m;
  geometry.p_DB = nominal.X_DB.p.head<2>();
  geometry.wheel_radius_m = nominal.wheel_radius_m;
  geometry.track_m = nominal.track_m;
  geometry.mouth_height_m = nominal.mouth_height_m;
  geometry.rock_map = nominal.rock_map;
  return geometry;
}

TipPlace TipOf(const PlanGeometry& geometry, const Pose2& X_DR) {
  return {X_DR.x + geometry.arm_m * std::cos(X_DR.heading),
          X_DR.y + geometry.arm_m * std::sin(X_DR.heading)};
}

double BoardBearing(const PlanGeometry& geometry, const Pose2& X_DR) {
  const Eigen::Vector2d to = geometry.p_DB - Eigen::Vector2d(X_DR.x, X_DR.y);
  return WrapPi(std::atan2(to.y(), to.x()) - X_DR.heading);
}

bool SeesBoard(const PlanGeometry& geometry, const LookOptions& look, const Pose2& X_DR) {
  const double range = (geometry.p_DB - Eigen::Vector2d(X_DR.x, X_DR.y)).norm();
  const double half = std::atan2(geometry.board_half_width_m, range);
  return std::abs(BoardBearing(geometry, X_DR)) + look.board_share * half <=
         geometry.half_view_rad - look.view_margin_rad;
}

double TetherAngle(const PlanGeometry& geometry, const Pose2& X_DR) {
  const TipPlace tip = TipOf(geometry, X_DR);
  return WrapPi(std::atan2(-tip.offset_m, -tip.gap_m) - X_DR.heading);
}

}  // namespace dockyard::axel
