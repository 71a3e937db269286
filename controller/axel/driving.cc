#include "controller/axel/driving.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dockyard::axel {

Driving::Driving(const Nominal& nominal, const AxelOptions& options)
    : nominal_(nominal), options_(options), geometry_(PlanGeometryOf(nominal)) {}

void Driving::Tell(const MappedRock& rock) {
  const auto known = [&](const MappedRock& other) {
    return std::hypot(other.x_m - rock.x_m, other.y_m - rock.y_m) < rock.radius_m &&
           other.height_m >= rock.height_m;
  };
  std::vector<MappedRock>& rocks = geometry_.rock_map.rocks;
  if (std::none_of(rocks.begin(), rocks.end(), known)) rocks.push_back(rock);
}

// Near the dock and facing it, the axle's own roll tells of the ground there, which undulates about
// the plane.
Drift Driving::DriftOf(const Senses& senses) const {
  const Pose2 X_DR = senses.pose();
  const bool there = std::hypot(X_DR.x, X_DR.y) < options_.plan.align_range_m &&
                     std::abs(WrapPi(X_DR.heading - kPi)) < options_.plan.facing_rad;
  const double slope = there ? senses.side_slope() : SlopeForceAt(senses.ground(), kPi);
  const Eigen::Vector2d& lean_D = senses.ground().lean_D();
  return {senses.side_drift(), senses.filter().slip().slope * slope, -lean_D.x(), -lean_D.y()};
}

void Driving::Put(const AxisPlan& plan, std::vector<Arc> leg) {
  plan_ = plan;
  leg_ = std::move(leg);
  planned_ = Planned(plan_);
  ++plan_count_;
}

bool Driving::Held(const Senses& senses) const {
  if (!leg_from_) return false;
  const Pose2 X_DR = senses.pose();
  const double way_m = std::hypot(X_DR.x - leg_from_->x, X_DR.y - leg_from_->y);
  return way_m < options_.plan.held_share * Length(leg_);
}

Event Driving::PlanNext(const Senses& senses) {
  Decision decision = Decide(geometry_, options_, senses.pose(), history_, DriftOf(senses));
  if (decision.event == Event::kGoRecover) return decision.event;
  Put(decision.plan, std::move(decision.leg));
  ++legs_;
  return decision.event;
}

std::optional<Event> Driving::PlanOnward(const Senses& senses) {
  Decision decision = Decide(geometry_, options_, senses.pose(), history_, DriftOf(senses));
  if (decision.event != Event::kGoApproach && decision.event != Event::kGoAlign)
    return std::nullopt;
  Put(decision.plan, std::move(decision.leg));
  ++legs_;
  return decision.event;
}

bool Driving::PlanEntry(const Senses& senses) {
  const double drift = senses.side_drift();
  const Pose2 X_DR = senses.pose();
  if (!CanMate(geometry_, options_, X_DR, drift)) return false;
  const double way_m =
      TipOf(geometry_, X_DR).gap_m - options_.mate.enter_gap_m + 0.5 * nominal_.paddle_pitch_m;
  const std::vector<Arc> on{{std::max(0.0, way_m), 0.0}};
  Put({MouthLineAt(geometry_, options_.mate, X_DR.x, drift), on}, on);
  ++legs_;
  return true;
}

void Driving::PlanBack(const Senses& senses) {
  const AxisPlan back = PlanRecovery(geometry_, options_, senses.pose(), history_, DriftOf(senses));
  Put(back, back.arcs);
  ++legs_;
  ++history_.recoveries;
}

void Driving::LearnMouthDrift(double off_m) {
  const MateOptions& mate = options_.mate;
  const double most = mate.learned_aside_m / mate.learned_way_m;
  geometry_.mouth_drift =
      std::clamp(geometry_.mouth_drift - off_m / mate.learned_way_m, -most, most);
}

double Driving::BesideMouthLine(const Senses& senses) const {
  const Pose2 X_DR = senses.pose();
  const Pose2 line = MouthLineAt(geometry_, options_.mate, X_DR.x, senses.side_drift());
  return X_DR.y - line.y;
}

void Driving::PlanAhead(const Senses& senses, double way_m) {
  const AxisPlan plan = PlanToAxis(geometry_, options_, senses.pose(), {}, DriftOf(senses));
  Put(plan, Truncate(plan.arcs, way_m));
  ++legs_;
}

void Driving::Enter(Phase phase, const Senses& senses) {
  driver_.reset();
  const bool to_axis =
      phase == Phase::kApproach || phase == Phase::kAlign || phase == Phase::kBackOff;
  const bool to_mouth = phase == Phase::kMate || phase == Phase::kEnter;
  const bool back = phase == Phase::kBackOff || phase == Phase::kRecover;
  if (to_axis) history_.under_way = true;
  if (phase == Phase::kRecover || phase == Phase::kSearch || phase == Phase::kRight)
    history_.under_way = false;
  if (phase == Phase::kBackOff) ++history_.back_offs;
  if (back) history_.backed_to.push_back(Advance(plan_.start, leg_));
  may_plan_anew_ = to_axis && !back;
  if (may_plan_anew_) {
    leg_from_ = senses.pose();
  } else if (phase != Phase::kTighten && phase != Phase::kLook) {
    leg_from_.reset();
  }
  const DriveOptions& drive = options_.drive;
  if (to_mouth) {
    LegDriver::Speed speed{drive.mate_m_s, drive.mate_m_s, drive.fine_steering};
    speed.by_tip = true;
    if (phase == Phase::kEnter) speed.thrust_n = options_.mate.enter_thrust_n;
    Start(speed, senses.now());
  } else if (to_axis || back) {
    LegDriver::Speed speed{drive.approach_m_s, drive.reverse_m_s, drive.steering};
    speed.pays_out = back && digs_ > 0;
    Start(speed, senses.now());
  }
}

void Driving::Start(const LegDriver::Speed& speed, Tick now) {
  speed_ = speed;
  off_since_.reset();
  driver_.emplace(nominal_, options_, plan_.start, leg_, speed, now);
}

// Critically damped, an offset y and a heading h beside the path become, after the way l,
//   y(l) = (y + (h + y/s) l) exp(-l/s),   h(l) = (h - (h + y/s) l/s) exp(-l/s).
bool Driving::OffPlan(const Senses& senses) const {
  const Pose2 off = driver_->Beside(senses.pose(), senses.side_drift());
  const double s = speed_.steering.settle_m;
  const double l = Length(plan_.arcs) - Length(leg_) + driver_->Remaining();
  const double rate = off.heading + off.y / s, left = std::exp(-l / s);
  return std::abs((off.y + rate * l) * left) > options_.plan.anew_offset_m ||
         std::abs((off.heading - rate * l / s) * left) > options_.plan.anew_heading_rad;
}

void Driving::PlanAnew(const Senses& senses) {
  if (!may_plan_anew_ || !driver_ || driver_->paused()) return;
  const double rest_m = driver_->Remaining();
  const bool under_way = Length(leg_) - rest_m >= options_.plan.anew_way_m;
  if (!under_way || rest_m < 0.5 * options_.plan.anew_way_m || !OffPlan(senses)) {
    off_since_.reset();
    return;
  }
  if (!off_since_) off_since_ = senses.now();
  if (senses.now() - *off_since_ < options_.plan.anew_after) return;
  const AxisPlan plan = PlanOn(geometry_, options_, senses.pose(), DriftOf(senses));
  off_since_.reset();
  if (plan.arcs.empty()) return;
  Put(plan, Truncate(plan.arcs, rest_m));
  Start(speed_, senses.now());
}

LegDriver::Status Driving::Drive(Senses* senses, Commands* commands) {
  PlanAnew(*senses);
  const LegDriver::Status status = driver_->Drive(senses, commands);
  digs_ += status == LegDriver::Status::kDigs;
  return status;
}

}  // namespace dockyard::axel
