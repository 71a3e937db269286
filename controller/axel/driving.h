// Plans the legs and drives them; remembers what was driven.
#pragma once

#include <optional>
#include <vector>

#include "controller/axel/leg.h"
#include "controller/axel/planner.h"

namespace dockyard::axel {

class Driving {
 public:
  Driving(const Nominal& nominal, const AxelOptions& options);

  const PlanGeometry& geometry() const { return geometry_; }
  /// A rock to keep off, unless one as high is known there.
  void Tell(const MappedRock& rock);

  /// After a sighting: whether the last leg to the axis made hardly any way.
  bool Held(const Senses& senses) const;
  /// After a sighting: plans the next leg, and what it is for. Nothing is planned for kGoRecover.
  Event PlanNext(const Senses& senses);
  /// At a leg's end under way: plans the next forward leg to the axis, if that is what comes next.
  std::optional<Event> PlanOnward(const Senses& senses);
  /// With the tip at the mouth: whether the arm will seat. If so, plans the rest of the way.
  bool PlanEntry(const Senses& senses);
  void PlanBack(const Senses& senses);
  /// The axle came out this far to D's +y of where it should be, at the mouth or in the socket: it
  /// drifts by as much more on the last of the way than it reckons.
  void LearnMouthDrift(double off_m);
  /// The axle beside the line to the mouth, to D's +y [m].
  double BesideMouthLine(const Senses& senses) const;
  /// On by dead reckoning, this far.
  void PlanAhead(const Senses& senses, double way_m);

  /// A phase begins: its leg does, too, if it drives one.
  void Enter(Phase phase, const Senses& senses);
  /// Begins the leg that was planned last.
  void Start(const LegDriver::Speed& speed, Tick now);
  /// Drives on. When the rover has come off its plan by more than the steering can bring back, the
  /// rest is planned anew.
  LegDriver::Status Drive(Senses* senses, Commands* commands);
  double left_m() const { return driver_ ? driver_->Remaining() : 0.0; }  // of the leg
  bool paused() const { return driver_ && driver_->paused(); }

  /// The plan in force, and how many there were.
  const std::vector<PlannedArc>& plan() const { return planned_; }
  int plan_count() const { return plan_count_; }
  bool over_rock() const { return plan_.over_rock; }  // of the plan in force
  int legs() const { return legs_; }                  // of them planned at a leg's start
  int recoveries() const { return history_.recoveries; }

 private:
  Drift DriftOf(const Senses& senses) const;
  void Put(const AxisPlan& plan, std::vector<Arc> leg);
  bool OffPlan(const Senses& senses) const;
  void PlanAnew(const Senses& senses);

  Nominal nominal_;
  AxelOptions options_;
  PlanGeometry geometry_;
  PlanHistory history_;
  AxisPlan plan_;
  std::vector<Arc> leg_;  // its first part
  LegDriver::Speed speed_;
  std::optional<LegDriver> driver_;
  std::optional<Pose2> leg_from_;  // X_DR where the last leg to the axis began
  bool may_plan_anew_ = false;
  std::optional<Tick> off_since_;
  std::vector<PlannedArc> planned_;
  int plan_count_ = 0, legs_ = 0;
  int digs_ = 0;  // legs on which the wheels dug
};

}  // namespace dockyard::axel
