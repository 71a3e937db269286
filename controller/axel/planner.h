// Chooses the next drive: a pure function of the estimated pose.
#pragma once

#include <vector>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/phases.h"
#include "controller/io/belief.h"
#include "controller/motion/arcs.h"

namespace dockyard::axel {

/// Dimensions of rover and station for the planner.
struct PlanGeometry {
  double arm_m = 0.0;
  double mating_depth_m = 0.0;
  double half_view_rad = 0.0;  // of the lens, sideways
  double board_half_width_m = 0.0;
  Eigen::Vector2d p_DB = Eigen::Vector2d::Zero();  // board's centre in the plane
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

/// Whether the arm will seat if the rover drives straight on: heading within the tolerance, tip
/// within the mouth, and the arm's final angle in the socket within its limit.
bool Aligned(const PlanGeometry& geometry, const MateOptions& mate, const Pose2& X_DR);
/// Angle of the arm against the cone's axis when seated, for an axle y beside the axis [rad].
double SocketAngle(const PlanGeometry& geometry, double axle_offset_m);

/// What the rover did before it plans again.
struct PlanHistory {
  bool under_way = false;  // it has driven the first part of a plan to the axis
  int back_offs = 0;       // of the run so far
};

/// Back off if that pays, then two forward arcs to the alignment goal. Minimises Eq. (14) of the
/// Rocky 7 paper plus turning, way out of view and way with the tether far to the side. A new plan
/// keeps to wider arcs than the rest of one that is under way, so that the rover's own errors do
/// not send it back; and each back-off is longer than the one before, so that it does not come back
/// to the same place. Falls back on a straight line backwards if nothing fits.
std::vector<Arc> PlanToAxis(const PlanGeometry& geometry, const AxelOptions& options,
                            const Pose2& X_DR, const PlanHistory& history = {});
/// Straight out of the cone if in it, then two reverse arcs to the recovery goal.
std::vector<Arc> PlanRecovery(const PlanGeometry& geometry, const AxelOptions& options,
                              const Pose2& X_DR);
/// The first part of a plan, up to the next image pair. A move backwards is driven whole.
std::vector<Arc> FirstLeg(const PlanGeometry& geometry, const AxelOptions& options,
                          const Pose2& X_DR, const std::vector<Arc>& plan);

struct Decision {
  Event event = Event::kGoApproach;
  std::vector<Arc> plan;  // whole
  std::vector<Arc> leg;   // to drive now
};
/// After a sighting: mate, recover, or the next leg.
Decision Decide(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                const PlanHistory& history = {});

/// A path in the belief's form.
std::vector<PlannedArc> Planned(const std::vector<Arc>& arcs, const Pose2& X_DR_start);

}  // namespace dockyard::axel
