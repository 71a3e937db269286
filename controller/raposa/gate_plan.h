// The shortest safe way onto the pyramid's axis: turns in place and straight legs round it.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"
#include "controller/raposa/dockyard_options.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// Turn to the heading, then drive length_m straight (negative: backwards).
struct Leg {
  double heading_rad = 0.0;  // in D
  double length_m = 0.0;
  Eigen::Vector2d p_D_end{0.0, 0.0};
};

struct GatePlan {
  std::vector<Leg> legs;  // then turn to face the pyramid, heading pi in D
  double time_s = 0.0;    // as reckoned
};

/// A leg across the line of sight to the guide, towards the gate: what it changes in the image
/// tells a pose from its mirrored one.
Leg AcrossSight(const Pose2& X_DN, double length_m, const DockyardOptions& options);

/// From N's pose in D to the soonest gate on the axis, with at most two waypoints round the
/// pyramid, each leg forwards or backwards, whichever turns less in all. A robot too near to turn
/// drives away first. Every leg, and every turn, keeps its distance from the pyramid.
GatePlan PlanToGate(const Pose2& X_DN, const Nominal& nominal, const DockyardOptions& options);

/// Whether the robot can drive straight in from there.
bool InCone(const Pose2& X_DN, const DockyardOptions& options);

}  // namespace dockyard::raposa
