// Chooses the next drive: a pure function of the estimated pose and of what was done before.
#pragma once

#include <vector>

#include "controller/axel/axis_plan.h"
#include "controller/axel/mouth_way.h"
#include "controller/axel/phases.h"
#include "controller/axel/plan_geometry.h"
#include "controller/io/belief.h"

namespace dockyard::axel {

/// The arcs backwards with which a plan begins.
std::vector<Arc> WayBack(const std::vector<Arc>& arcs);

/// Straight out of the cone if in it, then two reverse arcs to the recovery goal on the line to the
/// mouth, behind the rover and farther out each time; among rocks to the nearest such goal that no
/// rock bars.
AxisPlan PlanRecovery(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                      const PlanHistory& history = {}, const Drift& drift = {});

/// The first part of a plan, up to the next image pair. A move backwards is driven whole. The leg
/// ends with the board in view and, if it can, where a rover that has come to its side by as much
/// as the belief may be off can still go on forwards.
std::vector<Arc> FirstLeg(const PlanGeometry& geometry, const AxelOptions& options,
                          const AxisPlan& plan, const Drift& drift = {});

struct Decision {
  Event event = Event::kGoApproach;
  AxisPlan plan;         // whole
  std::vector<Arc> leg;  // to drive now
};
/// After a sighting: mate, recover, or the next leg.
Decision Decide(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                const PlanHistory& history = {}, const Drift& drift = {});

/// A path in the belief's form.
std::vector<PlannedArc> Planned(const AxisPlan& plan);
std::vector<PlannedArc> Planned(const std::vector<Arc>& arcs, const Pose2& X_DR_start);

}  // namespace dockyard::axel
