// Wheels slip sideways under a side force, about in proportion to it: on a cross slope the rover
// drifts downhill, and beside a taut tether towards the mouth. Neither wheels nor inertial unit
// show it.
#pragma once

#include "controller/axel/ground_slope.h"
#include "controller/axel/tether_length.h"
#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

/// Forces on the rover to its left, in shares of its weight.
struct SideForce {
  double slope = 0.0;   // of gravity along the axle
  double tether = 0.0;  // of the tether's tension across the arm
};

/// Sideways way to the left for each metre of way and each share of the weight.
struct SideSlip {
  double slope = 1.0, tether = 1.0;

  /// Of the way, to the left: the tangent of the angle between course and heading.
  double Drift(const SideForce& force) const { return slope * force.slope + tether * force.tether; }
};

/// tether_n: the tension. weight_n: of the rover.
SideForce SideForceOn(const ImuSample& imu, const TetherGeometry& geometry, const Pose2& X_DR,
                      double tether_n, double weight_n);

/// Gravity's share on a rover that stands with this heading on the dock's slope.
double SlopeForceAt(const GroundSlope& ground, double heading_rad);

}  // namespace dockyard::axel
