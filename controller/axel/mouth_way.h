// The last third of a metre: the line to the mouth, and whether the rover can still drive it.
#pragma once

#include "controller/axel/plan_geometry.h"

namespace dockyard::axel {

/// Angle of the arm against the cone's axis when seated, for an axle y beside the axis [rad].
double SocketAngle(const PlanGeometry& geometry, double axle_offset_m);

/// Whether the arm will seat if the rover rolls straight on: heading within the tolerance, tip
/// within the mouth, and the arm's final angle in the socket within its limit.
bool Aligned(const PlanGeometry& geometry, const MateOptions& mate, const Pose2& X_DR);

/// Place x_m before the dock on the line that ends with the tip in the middle of the mouth, and the
/// course there, of a rover that faces the station squarely and drifts to its left by this share of
/// its way. On the last of it the rover drifts as it has learned, too.
Pose2 MouthLineAt(const PlanGeometry& geometry, const MateOptions& mate, double x_m, double drift);

/// The turn [rad/s] that brings the tip to the cone's axis while the axle rolls on and drifts. The
/// axle follows like a trailer's.
double TurnForTip(double arm_m, const Pose2& X_DR, double speed_m_s, double drift,
                  const Steering& steering);

/// Where the rover is with its tip in the mouth, after its tip has been steered there from here.
Pose2 AfterMouthLine(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                     double drift);
/// Whether the arm will seat from there, with the learned drift or without: it may not come again.
bool CanMate(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
             double drift);

}  // namespace dockyard::axel
