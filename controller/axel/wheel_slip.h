// Wheels slip under a force, about in proportion to it: along their way by what pulls or holds the
// rover, sideways downhill on a cross slope and towards the mouth beside a taut tether. Neither
// wheels nor inertial unit show it.
#pragma once

#include "controller/axel/ground_slope.h"
#include "controller/axel/tether_length.h"
#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

/// Forces on the rover, in shares of its weight.
struct GroundForce {
  double slope = 0.0;   // of gravity along the axle, to the left
  double tether = 0.0;  // of the tether's tension across the arm, to the left
  double ahead = 0.0;   // of gravity and tension together, along the heading
};

/// What a force makes of the wheels' way.
struct WheelSlip {
  double slope = 1.0, tether = 1.0;  // sideways way for each metre of way and share of the weight
  double rolling = 0.0;              // share of the way that is lost without any force
  double ahead = 0.0;                // way ahead for each metre of way and share of the weight

  /// Of the way, to the left: the tangent of the angle between course and heading.
  double Drift(const GroundForce& force) const {
    return slope * force.slope + tether * force.tether;
  }
  /// Along the heading, of wheels that rolled rolled_m, backwards negative.
  double Way(double rolled_m, const GroundForce& force) const;
};

/// tether_n: the tension. weight_n: of the rover.
GroundForce GroundForceOn(const ImuSample& imu, const GroundSlope& ground,
                          const TetherGeometry& geometry, const Pose2& X_DR, double tether_n,
                          double weight_n);

/// Gravity's share to the left of a rover that stands with this heading on the dock's slope.
double SlopeForceAt(const GroundSlope& ground, double heading_rad);

}  // namespace dockyard::axel
