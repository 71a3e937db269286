// Where arm, board and tether are when the rover stands at a pose, in the plane.
#pragma once

#include <Eigen/Core>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/geometry/pose.h"

namespace dockyard::axel {

/// Dimensions of rover and station for the planner.
struct PlanGeometry {
  double arm_m = 0.0;
  double mating_depth_m = 0.0;
  double half_view_rad = 0.0;  // of the lens, sideways
  double board_half_width_m = 0.0;
  Eigen::Vector2d p_DB = Eigen::Vector2d::Zero();  // board's centre in the plane
  double wheel_radius_m = 0.0;                     // with its paddles
  double track_m = 0.0;                            // between the wheels' middles
  double mouth_height_m = 0.0;                     // centre of the cone's mouth above the ground
  RockMap rock_map{};                              // rocks that it was told of
  double mouth_drift = 0.0;  // on the last of the way to the mouth, beyond the drift (learned)
};
PlanGeometry PlanGeometryOf(const Nominal& nominal);

/// The arm's tip in the plane: its distance before the mouth plane (negative inside) and its offset
/// to the left of the axis as D counts it (+y).
struct TipPlace {
  double gap_m = 0.0, offset_m = 0.0;
};
TipPlace TipOf(const PlanGeometry& geometry, const Pose2& X_DR);

/// Board's bearing off the nose [rad], positive to the left.
double BoardBearing(const PlanGeometry& geometry, const Pose2& X_DR);
bool SeesBoard(const PlanGeometry& geometry, const LookOptions& look, const Pose2& X_DR);
/// In plan, tether (tip to mouth) against arm [rad], positive to the left.
double TetherAngle(const PlanGeometry& geometry, const Pose2& X_DR);

}  // namespace dockyard::axel
