// Length of the exposed tether: Tsai et al., Eq. (1), with the true places of mouth, anchor and arm
// instead of one common origin.
#pragma once

#include <Eigen/Core>

#include "controller/axel/nominal/nominal.h"
#include "controller/geometry/pose.h"
#include "controller/motion/arcs.h"

namespace dockyard::axel {

/// Eq. (1): tether from the arm's tip to a station at the origin, in the plane [m].
double CosineLawTether(double arm_m, const DockingCoords& at);

/// The dimensions that set the exposed length, in the dock frame D.
struct TetherGeometry {
  // Centre of the throat, through which the tether always runs [m].
  Eigen::Vector3d p_DQ = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_DA = Eigen::Vector3d::Zero();  // anchor behind it on the cone's axis [m]
  double arm_m = 0.0;                              // axle to tip
  double axle_height_m = 0.0;
};
TetherGeometry TetherGeometryOf(const Nominal& nominal);

/// Arm tip in D for an arm raised by elevation_rad above the horizontal.
Eigen::Vector3d TipInDock(const TetherGeometry& geometry, const Pose2& X_DR, double elevation_rad);

/// Exposed length [m]: tip to the centre of the throat and on to the anchor; with the tip beyond
/// the throat, straight to the anchor. The cone's lip, mouth radius 0.1 m, makes the true path from
/// 40 deg aside about a centimetre longer; only the change of the length matters.
double ExposedTether(const TetherGeometry& geometry, const Pose2& X_DR, double elevation_rad);

/// Its derivative by x, y [-] and heading [m/rad] of X_DR, by central differences of 0.1 mm.
Eigen::Vector3d ExposedTetherSlope(const TetherGeometry& geometry, const Pose2& X_DR,
                                   double elevation_rad);

/// How fast the exposed length grows [m/s] while the axle moves at speed_m_s and the rover turns
/// at turn_rad_s: the exact schedule for the spool along an arc.
double ExposedTetherRate(const TetherGeometry& geometry, const Pose2& X_DR, double elevation_rad,
                         double speed_m_s, double turn_rad_s);

}  // namespace dockyard::axel
