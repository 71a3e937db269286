#include "controller/axel/machine.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "controller/axel/machine_impl.h"
#include "controller/axel/rock_check.h"
#include "controller/axel/station_hold.h"
#include "controller/base/check.h"
#include "controller/motion/limits.h"

namespace dockyard::axel {
namespace {

// Before the mouth coming out of a hole would drive the tip onto the rim.
bool RoomAhead(const PlanGeometry& geometry, const AxelOptions& options, const Senses& senses) {
  const double gap_m = TipOf(geometry, senses.pose()).gap_m;
  return gap_m >= options.dig.out_m + options.plan.min_tip_gap_m;
}

}  // namespace

AxelMachine::AxelMachine(const Nominal& nominal, const AxelOptions& options, Locator locator)
    : nominal_(nominal),
      options_(options),
      perception_{std::move(locator)},
      senses_(nominal, options),
      driving_(nominal, options),
      arm_(nominal, options.arm),
      felt_rocks_(nominal.track_m, options.felt_rocks, RockLimits{}),
      righting_(nominal, options.righting),
      looks_(options, nominal),
      stop_(nominal, options),
      judge_(options.look, nominal.X_DB),
      search_(nominal, options),
      entry_(nominal, options),
      reel_in_(nominal, options),
      seat_check_(nominal, options),
      haul_(nominal, options),
      excursion_(nominal, options),
      still_(options.tether.still_m) {
  DOCKYARD_CHECK(perception_.locator != nullptr);
  belief_.phase = Name(phase_);
  belief_.values = {{"tether_length_m", 0.0}, {"recoveries", 0.0}, {"rightings", 0.0}};
}

Commands AxelMachine::Step(const SensorFrame& sensed) {
  senses_.Update(sensed);
  if (!entered_) Enter(nominal_.excursion_m > 0.0 ? Phase::kUndock : Phase::kTighten);
  const auto change = [&](Event event) {
    const std::optional<Phase> next = Next(phase_, event);
    DOCKYARD_CHECK(next.has_value());
    Enter(*next);
  };
  Commands commands = BrakedCommands();
  FeelRocks();
  if (const std::optional<Event> event = TurnedOver()) change(*event);
  const std::optional<Event> event = Act(sensed, &commands);
  if (phase_ != Phase::kRight) CommandOf(&commands, Motor::kArm) = arm_.Hold(senses_);
  if (event) change(*event);
  commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDone
                     : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                 : Verdict::kUnderWay;
  FillBelief();
  KeepLimits(nominal_.motors, &commands);
  return commands;
}

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
    case Phase::kOut:
      return ComeOut(commands);
    case Phase::kReel:
      return reel_in_.Step(senses_, commands) ? std::optional(Event::kReeledIn) : std::nullopt;
    case Phase::kConfirm:
      return Confirm(sensed, commands);
    case Phase::kHaul:
      return HaulIn(commands);
    case Phase::kUndock:
      return GoOut(UndockedWay(nominal_, options_.excursion), commands);
    case Phase::kExcursion:
      return GoOut(nominal_.excursion_m, commands);
    case Phase::kReturn:
      return excursion_.back_m() > 0.0 ? Drive(commands) : Event::kArrived;
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
  const bool to_axis = phase_ == Phase::kApproach || phase_ == Phase::kAlign;
  if (to_axis && search_.StopsAbeam(Known())) {
    belief_.note = "tether abeam";
    search_.Seek();  // so that it is pulled first
    return Event::kArrived;
  }
  if (phase_ == Phase::kEnter &&
      entry_.Over(senses_, TipOf(driving_.geometry(), senses_.pose()).gap_m)) {
    if (entry_.felt()) belief_.note = "tip feels the cone";
    return Event::kArrived;
  }
  if (status == LegDriver::Status::kUnderWay) return std::nullopt;
  if (status == LegDriver::Status::kFellShort) belief_.note = "leg fell short";
  if (status == LegDriver::Status::kDigs) {
    belief_.note = "wheels dig";
    const bool back = phase_ == Phase::kBackOff || phase_ == Phase::kRecover;
    return back && RoomAhead(driving_.geometry(), options_, senses_) ? Event::kDigs
                                                                     : Event::kArrived;
  }
  const std::optional<Event> onward = GoesOn(status) ? driving_.PlanOnward(senses_) : std::nullopt;
  return onward.value_or(Event::kArrived);
}

// By the drum, as the wheels slip.
std::optional<Event> AxelMachine::ComeOut(Commands* commands) {
  const double pull_n =
      std::min(options_.tether.first_tension_n, SurePull(nominal_, options_.hold, senses_));
  DriveOut(nominal_, options_, pull_n, commands);
  const bool out = senses_.reeled_m() - entered_->reeled_m >= options_.dig.out_m;
  return out || InPhase() >= options_.dig.out_limit ? std::optional(Event::kArrived) : std::nullopt;
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

std::optional<Event> AxelMachine::TurnedOver() {
  if (phase_ == Phase::kDocked || phase_ == Phase::kGivenUp || phase_ == Phase::kRight)
    return std::nullopt;
  const bool at_rest = phase_ == Phase::kTighten || phase_ == Phase::kLook;
  if (!righting_.TurnedOver(senses_, at_rest)) return std::nullopt;
  belief_.note = "turned over";
  if (tries_.rightings >= options_.limit.rightings) return Event::kLimitReached;
  ++tries_.rightings;
  return Event::kTurnedOver;
}

std::optional<Event> AxelMachine::TurnBack(Commands* commands) {
  const Righting::Status status = righting_.Step(senses_, commands);
  if (status == Righting::Status::kUnderWay) return std::nullopt;
  arm_.Reset();
  return status == Righting::Status::kDone ? Event::kArrived : Event::kLimitReached;
}

// A rover that does not get out goes back: how far it was is not for it to claim.
std::optional<Event> AxelMachine::GoOut(double distance_m, Commands* commands) {
  const Excursion::Status status = excursion_.Step(distance_m, InPhase(), &senses_, commands);
  if (status == Excursion::Status::kLate) belief_.note = "does not get out as far as told";
  if (status != Excursion::Status::kUnderWay) return Event::kArrived;
  if (std::abs(senses_.pitch_rad()) < Radians(45.0)) arm_.Level(senses_);
  return std::nullopt;
}

// By dead reckoning.
void AxelMachine::DriveOn(double distance_m) {
  driving_.PlanAhead(senses_, distance_m);
  const DriveOptions& drive = options_.drive;
  driving_.Start({drive.approach_m_s, drive.reverse_m_s, drive.steering}, senses_.now());
}

void AxelMachine::Enter(Phase phase) {
  if (phase == Phase::kReel && phase_ == Phase::kConfirm) {
    reel_in_.Wiggle(senses_);
  } else if (phase == Phase::kReel) {
    reel_in_.Begin(senses_, TipOf(driving_.geometry(), senses_.pose()).gap_m);
  }
  phase_ = phase;
  entered_ = MomentOf(senses_);
  still_.Reset();
  levelling_.reset();
  looks_.Begin(senses_.now());
  driving_.Enter(phase, senses_);
  if (phase != Phase::kLook) taut_ = false;
  switch (phase) {
    case Phase::kLook:
    case Phase::kRecheck:
      stop_.Begin(senses_.now());
      return judge_.NewStop();
    case Phase::kSearch:
      search_.Begin(senses_, Known());
      if (search_.action() && search_.action()->move == SearchMove::kAdvance)
        DriveOn(search_.action()->amount);
      return;
    case Phase::kConfirm:
      return seat_check_.Begin();
    case Phase::kRight:
      return righting_.Begin(senses_);
    case Phase::kHaul:
      return haul_.Begin(senses_);
    case Phase::kUndock:
      return excursion_.Begin(&senses_);
    case Phase::kReturn:
      excursion_.PlanReturn(senses_);
      if (excursion_.back_m() > 0.0) DriveOn(excursion_.back_m());
      return;
    case Phase::kEnter:
      entry_.Begin();
      return search_.Drives();
    case Phase::kApproach:
    case Phase::kAlign:
    case Phase::kBackOff:
    case Phase::kRecover:
    case Phase::kMate:
      return search_.Drives();
    default:
      return;
  }
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
  belief_.values[2].value = tries_.rightings;
}

std::unique_ptr<Controller> MakeAxelMachine(const Nominal& nominal, const AxelOptions& options,
                                            Locator locator) {
  return std::make_unique<AxelMachine>(nominal, options, std::move(locator));
}

}  // namespace dockyard::axel
