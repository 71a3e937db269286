// The way to the alignment goal before the mouth: two arcs forwards, behind a back-off if that
// pays.
#pragma once

#include <vector>

#include "controller/axel/plan_geometry.h"
#include "controller/motion/arcs.h"

namespace dockyard::axel {

/// Sideways way to the rover's left for each metre of way. A rover that drifts keeps a course
/// beside its heading. With it the slope, which it comes of.
struct Drift {
  double here = 0.0;
  double at_dock = 0.0;  // facing the station, by the ground's slope
  // What pulls the rover downhill, over its weight, along D's x and y.
  double downhill_x = 0.0, downhill_y = 0.0;
};

/// What the rover did before it plans again.
struct PlanHistory {
  bool under_way = false;  // it has driven the first part of a plan to the axis
  int back_offs = 0;       // of the run so far, as the next two
  int recoveries = 0;
  std::vector<Pose2> backed_to{};  // ends of its back-offs and recoveries

  /// Whether it has backed to this place before, in about this heading.
  bool BackedTo(const Pose2& X_DR) const;
};

/// The way that the middle of a rover takes that drifts, forwards or, seen from the front,
/// backwards: {x, y, course}.
Pose2 CourseOf(const Pose2& X_DR, double drift, bool forwards);

/// A path of the rover's middle; the start's heading is the course. No arcs: none was found.
struct AxisPlan {
  Pose2 start;
  std::vector<Arc> arcs;
  double cusp_turn_rad = 0.0;  // of the course where the rover goes forwards after a way back
  bool over_rock = false;      // no plan keeps clear of the rocks that it was told of
  double beyond_m = 0.0;       // of a rest: its cost beyond its length
};

/// The cheapest of three arcs to the alignment goal, the second and third forwards, of two, the
/// second forwards, or of a sharp turn backwards, a straight way back and two arcs: Eq. (14) of the
/// Rocky 7 paper plus turning, way out of view, way with the tether far to the side and way on
/// which the wheels' thrust may lift the arm. A new plan keeps to wider arcs than the rest of one
/// that is under way, so that the rover's own errors do not send it back. Each back-off is longer
/// than the one before and ends elsewhere than all before. Straight back if nothing fits. With a
/// map of rocks also three arcs forwards; if every plan crosses a rock, the one that does so least.
AxisPlan PlanToAxis(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                    const PlanHistory& history = {}, const Drift& drift = {});

/// The rest of a plan: two forward arcs as sharp as the rest may have, to the alignment goal or to
/// the nearest place before the mouth. With a map of rocks also three arcs, and none that crosses
/// one. No arcs: it would have to back off.
AxisPlan PlanOn(const PlanGeometry& geometry, const AxelOptions& options, const Pose2& X_DR,
                const Drift& drift = {});

}  // namespace dockyard::axel
