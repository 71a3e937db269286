#include "controller/axel/machine.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "controller/axel/machine_impl.h"
#include "controller/axel/rock_check.h"

namespace dockyard::axel {

std::optional<Event> AxelMachine::Act(const SensorFrame& sensed, Commands* commands) {
  switch (phase_) {
    case Phase::kTighten:
      return Tighten(commands);
    case Phase::kLook:
    case Phase::kRecheck:
      return Look(sensed, commands);
    case Phase::kSearch:
      return Search(commands);
    case Phase::kApproach:
    case Phase::kAlign:
      LookUnderWay(sensed, commands);
      return Drive(commands);
    case Phase::kBackOff:
    case Phase::kRecover:
    case Phase::kMate:
    case Phase::kEnter:
      return Drive(commands);
    case Phase::kReel:
      return Reel(commands);
    case Phase::kConfirm:
      return Confirm(sensed, commands);
    case Phase::kHaul:
      return HaulIn(commands);
    case Phase::kUndock:
      return GoOut(UndockedWay(nominal_, options_.excursion), commands);
    case Phase::kExcursion:
      return GoOut(nominal_.excursion_m, commands);
    case Phase::kReturn:
      return returns_ ? Drive(commands) : Event::kArrived;
    case Phase::kRight:
      return TurnBack(commands);
    case Phase::kDocked:
    case Phase::kGivenUp:
      break;
  }
  return std::nullopt;  // brakes: the default of Commands
}

Event AxelMachine::Recover(Event event, const std::string& why) {
  belief_.note = why;
  if (driving_.recoveries() >= options_.limit.recoveries) return Event::kLimitReached;
  driving_.PlanBack(senses_);
  return event;
}

std::optional<Event> AxelMachine::Drive(Commands* commands) {
  const LegDriver::Status status = driving_.Drive(&senses_, commands);
  // A body far from level is tumbling: the arm motor could only make it worse. Assumed, 50-70 deg.
  // An arm that is off the ground does not turn the body: levelling would only lift it farther.
  const bool arm_down = senses_.elevation_rad() < options_.drive.arm_resume_rad;
  const bool may_level =
      !driving_.paused() && arm_down && std::abs(senses_.pitch_rad()) < Radians(60.0);
  const bool to_mouth = phase_ == Phase::kMate || phase_ == Phase::kEnter;
  const bool high = !to_mouth && (held_ || BodyNearRock(driving_.geometry(), senses_.pose()));
  if (may_level) arm_.Level(senses_, high ? options_.arm.over_rock_rad : 0.0);
  if (driving_.paused()) belief_.note = "arm lifted: reeling in";
  if (StopsAbeam()) {
    belief_.note = "tether abeam";
    seeking_ = true;  // so that it is pulled first
    return Event::kArrived;
  }
  if (phase_ == Phase::kEnter &&
      entry_.Over(senses_, TipOf(driving_.geometry(), senses_.pose()).gap_m)) {
    if (entry_.felt()) belief_.note = "tip feels the cone";
    return Event::kArrived;
  }
  if (status == LegDriver::Status::kUnderWay) return std::nullopt;
  if (status == LegDriver::Status::kFellShort) belief_.note = "leg fell short";
  const std::optional<Event> onward = GoesOn(status) ? driving_.PlanOnward(senses_) : std::nullopt;
  return onward.value_or(Event::kArrived);
}

// Out of the cone, which tilts the rover by itself.
void AxelMachine::FeelRocks() {
  const bool in_the_open = phase_ == Phase::kTighten || phase_ == Phase::kLook ||
                           phase_ == Phase::kSearch || phase_ == Phase::kApproach ||
                           phase_ == Phase::kAlign || phase_ == Phase::kBackOff ||
                           phase_ == Phase::kRecover;
  if (!in_the_open) return felt_rocks_.Reset();
  const auto rock = felt_rocks_.Take(senses_.attitude(), senses_.reckoned(), senses_.pose());
  if (!rock || !senses_.filter().located()) return;
  driving_.Tell(*rock);
  belief_.note = "rock felt";
}

// The arm went over the top, or the rover starts so. An arm that only swings past the upright comes
// back by itself.
bool AxelMachine::TurnedOver() {
  const bool stands = phase_ == Phase::kTighten || phase_ == Phase::kLook;
  const bool over =
      senses_.arm_trails() || (stands && !Righting::Upright(senses_, options_.righting));
  const bool may = phase_ != Phase::kDocked && phase_ != Phase::kGivenUp && phase_ != Phase::kRight;
  if (!over || !may) {
    over_since_.reset();
    return false;
  }
  if (!over_since_) over_since_ = senses_.now();
  return senses_.now() - *over_since_ >= options_.righting.over_for;
}

Event AxelMachine::Right() {
  belief_.note = "turned over";
  if (rightings_ >= options_.limit.rightings) return Event::kLimitReached;
  ++rightings_;
  return Event::kTurnedOver;
}

std::optional<Event> AxelMachine::TurnBack(Commands* commands) {
  const Righting::Status status = righting_.Step(senses_, commands);
  if (status == Righting::Status::kUnderWay) return std::nullopt;
  arm_.Reset();
  return status == Righting::Status::kDone ? Event::kArrived : Event::kLimitReached;
}

void AxelMachine::Change(Event event) {
  const std::optional<Phase> next = Next(phase_, event);
  DOCKYARD_CHECK(next.has_value());
  Enter(*next);
}

void AxelMachine::Enter(Phase phase) {
  if (phase == Phase::kReel && phase_ == Phase::kConfirm) {
    reel_in_.Wiggle(senses_);
  } else if (phase == Phase::kReel) {
    reel_in_.Begin(senses_, TipOf(driving_.geometry(), senses_.pose()).gap_m);
  }
  phase_ = phase;
  entered_ = look_from_ = senses_.now();
  reeled_at_entry_m_ = senses_.reeled_m();
  yaw_at_entry_rad_ = senses_.yaw_rad();
  still_.Reset();
  levelling_since_.reset();
  rolled_before_m_ = senses_.rolled_m();
  asked_at_.reset();
  asks_ = 0;
  looks_.Begin(senses_.now());
  driving_.Enter(phase, senses_);
  braked_.reset();
  bracket_.NewStop();
  if (phase != Phase::kLook) taut_ = false;
  if (phase == Phase::kLook || phase == Phase::kRecheck) judge_.NewStop();
  if (phase == Phase::kSearch) BeginSearch();
  if (phase == Phase::kRight) righting_.Begin(senses_);
  if (phase == Phase::kHaul) haul_.Begin(senses_);
  if (phase == Phase::kEnter) entry_.Begin();
  if (phase == Phase::kUndock) BeginExcursion();
  if (phase == Phase::kReturn) BeginReturn();
  const bool drives = phase == Phase::kApproach || phase == Phase::kAlign ||
                      phase == Phase::kBackOff || phase == Phase::kRecover ||
                      phase == Phase::kMate || phase == Phase::kEnter;
  if (drives) seeking_ = false;
}

void AxelMachine::FillBelief() {
  belief_.phase = Name(phase_);
  belief_.located = senses_.filter().located();
  belief_.X_DR = senses_.pose();
  belief_.plan = driving_.plan();
  belief_.plan_count = driving_.plan_count();
  // Estimated: arm tip to anchor.
  belief_.values[0].value =
      belief_.located ? senses_.filter().ExposedLength(senses_.reeled_m()) : 0.0;
  belief_.values[1].value = driving_.recoveries();
  belief_.values[2].value = rightings_;
}

std::unique_ptr<Controller> MakeAxelMachine(const Nominal& nominal, const AxelOptions& options,
                                            Locator locator) {
  return std::make_unique<AxelMachine>(nominal, options, std::move(locator));
}

}  // namespace dockyard::axel
