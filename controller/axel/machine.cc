#include "controller/axel/machine.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "controller/axel/driving.h"
#include "controller/axel/haul.h"
#include "controller/axel/mating.h"
#include "controller/axel/phases.h"
#include "controller/axel/righting.h"
#include "controller/axel/search.h"
#include "controller/axel/seeker.h"
#include "controller/axel/senses.h"
#include "controller/axel/sighting.h"
#include "controller/base/check.h"
#include "controller/base/number_text.h"

namespace dockyard::axel {
namespace {

/// In place of the picture of a camera that gave none beside the other's.
GrayImage Dark(const GrayImage& other) {
  GrayImage dark{.width = other.width, .height = other.height, .pixels = {}};
  dark.pixels.resize(other.pixels.size());
  return dark;
}

std::optional<Event> ArrivedIf(bool arrived) {
  return arrived ? std::optional<Event>(Event::kArrived) : std::nullopt;
}

class AxelMachine final : public Controller {
 public:
  AxelMachine(const Nominal& nominal, const AxelOptions& options, Locator locator)
      : nominal_(nominal),
        options_(options),
        locator_(std::move(locator)),
        senses_(nominal, options),
        driving_(nominal, options),
        arm_(nominal, options.arm),
        righting_(nominal, options.righting),
        reel_in_(nominal, options),
        haul_(nominal, options),
        judge_(options.look, nominal.X_DB),
        seeker_(options.search),
        still_(options.tether.still_m) {
    DOCKYARD_CHECK(locator_ != nullptr);
    belief_.phase = Name(phase_);
    belief_.values = {{"tether_length_m", 0.0}, {"recoveries", 0.0}, {"rightings", 0.0}};
  }

  Commands Step(const SensorFrame& sensed) override {
    senses_.Update(sensed);
    if (!started_) Enter(Phase::kTighten);
    started_ = true;
    Commands commands = BrakedCommands();
    if (TurnedOver()) Change(Right());
    const std::optional<Event> event = Act(sensed, &commands);
    if (phase_ != Phase::kRight) {
      commands.motors[static_cast<std::size_t>(Motor::kArm)] = arm_.Hold(senses_);
    }
    if (event) Change(*event);
    commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDocked
                       : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                   : Verdict::kUnderWay;
    FillBelief();
    return WithinLimits(nominal_, commands);
  }

  const Belief& belief() const override { return belief_; }

 private:
  MotorCommand& Spool(Commands* commands) const {
    return commands->motors[static_cast<std::size_t>(Motor::kSpool)];
  }
  Tick InPhase() const { return senses_.now() - entered_; }
  double ReeledHere() const { return senses_.reeled_m() - reeled_at_entry_m_; }
  double RolledHere() const { return senses_.rolled_m() - rolled_before_m_; }
  double TurnedHere() const { return WrapPi(senses_.yaw_rad() - yaw_at_entry_rad_); }
  bool Stuck() {
    return still_.Still(senses_.now(), senses_.reeled_m()) >= options_.mate.stuck_after;
  }

  std::optional<Event> Act(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Tighten(Commands* commands);
  std::optional<Event> Look(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Drive(Commands* commands);
  std::optional<Event> Search(Commands* commands);
  std::optional<Event> Level(double target_pitch_rad, Commands* commands);
  std::optional<Event> Reel(Commands* commands);
  std::optional<Event> Confirm(const SensorFrame& sensed, Commands* commands);
  bool Steadied(Commands* commands);
  bool LookedAtHome(const SensorFrame& sensed, Commands* commands);
  Event RuleHome();
  std::optional<Event> TurnBack(Commands* commands);

  std::optional<StereoImages> Arrived(const SensorFrame& sensed);
  LocateOutput Locate(const StereoImages& images);
  std::optional<Event> Judge(const StereoImages& images);
  Event AfterSighting();
  Event AtTheMouth();
  Event Recover(Event event, const std::string& why);
  bool TurnedOver();
  Event Right();
  void BeginSearch();
  SearchKnowledge Known() const;
  bool TetherAbeam();
  bool StopsAbeam() const;
  Event GoBlind(const std::string& why);
  std::optional<Event> HaulIn(Commands* commands);

  void Change(Event event);
  void Enter(Phase phase);
  void FillBelief();

  const Nominal nominal_;
  const AxelOptions options_;
  const Locator locator_;
  Senses senses_;
  Driving driving_;
  ArmLevel arm_;
  Righting righting_;
  ReelIn reel_in_;
  Haul haul_;
  SightingJudge judge_;
  Seeker seeker_;
  CameraTurnFilter camera_turn_;
  StillWatch still_;

  bool started_ = false;
  Phase phase_ = Phase::kTighten;
  Tick entered_ = 0;
  double reeled_at_entry_m_ = 0.0, yaw_at_entry_rad_ = 0.0;
  double rolled_before_m_ = 0.0;  // when the wheels were freed
  Belief belief_;
  int rightings_ = 0;
  std::optional<Tick> over_since_;  // turned over

  // Tightening.
  std::optional<Tick> levelling_since_;
  bool taut_ = false;
  // Taking sightings.
  Tick look_from_ = 0;
  std::optional<Tick> asked_at_;
  int asks_ = 0;  // in a row without an answer
  // Searching.
  int attempts_ = 0, turning_pulls_ = 0, hauls_ = 0, recoveries_inside_ = 0;
  bool seeking_ = true;  // it has not driven since the board was lost
  std::optional<SearchAction> search_;
  // Confirming: when the spool was braked, where it stood, and what the picture then shows.
  struct Braked {
    Tick since = 0;
    double reeled_m = 0.0;
    bool looked = false;
    std::optional<double> depth_m{};
  };
  std::optional<Braked> braked_;
};

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
    case Phase::kRight:
      return TurnBack(commands);
    case Phase::kDocked:
    case Phase::kGivenUp:
      break;
  }
  return std::nullopt;  // brakes: the default of Commands
}

std::optional<Event> AxelMachine::Tighten(Commands* commands) {
  if (levelling_since_) return Level(0.0, commands);
  const TetherOptions& tether = options_.tether;
  StandStill(nominal_, options_.drive, InPhase(), commands);
  Spool(commands) = TautWinch(nominal_, tether);
  const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
  const bool waited = InPhase() >= options_.drive.stop_time + tether.taut_after;
  const bool taut = waited && still >= tether.taut_after;
  if (!taut && InPhase() < tether.tighten_limit) return std::nullopt;
  taut_ = taut;
  if (taut && senses_.filter().TetherKnown()) senses_.UseTether(0.0);
  if (!taut) belief_.note = "tether does not come taut";
  if (std::abs(senses_.pitch_rad()) <= options_.arm.look_pitch_rad) return Event::kTaut;
  levelling_since_ = senses_.now();
  rolled_before_m_ = senses_.rolled_m();
  return std::nullopt;
}

// The body turns about the axle only while the wheels are free. The braked spool holds the rover,
// but not from rolling downhill towards the station: then it stops and looks as it is.
std::optional<Event> AxelMachine::Level(double target_pitch_rad, Commands* commands) {
  const Event done = phase_ == Phase::kTighten ? Event::kTaut : Event::kArrived;
  if (std::abs(senses_.rolled_m() - rolled_before_m_) > options_.arm.level_roll_m) return done;
  SetWheels(MotorMode::kFree, commands);
  arm_.Level(senses_, target_pitch_rad);
  const bool level =
      std::abs(senses_.pitch_rad() - target_pitch_rad) <= 2.0 * options_.arm.dead_band_rad;
  const Tick since = senses_.now() - levelling_since_.value_or(entered_);
  if (!level && since < options_.arm.level_limit) return std::nullopt;
  return done;
}

std::optional<Event> AxelMachine::Look(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, options_.drive, InPhase(), commands);
  if (InPhase() < options_.drive.stop_time) Spool(commands) = TautWinch(nominal_, options_.tether);
  if (const std::optional<StereoImages> images = Arrived(sensed)) {
    asked_at_.reset();
    asks_ = 0;
    return Judge(*images);
  }
  if (senses_.now() - look_from_ < options_.look.settle) return std::nullopt;
  if (!asked_at_ || senses_.now() - *asked_at_ >= options_.look.image_limit << (asks_ - 1)) {
    if (asks_ == options_.look.unanswered_asks) {
      return GoBlind("cameras do not answer");
    }
    commands->take_images = {kLeftCamera, kRightCamera};
    asked_at_ = senses_.now();
    ++asks_;
  }
  return std::nullopt;
}

std::optional<StereoImages> AxelMachine::Arrived(const SensorFrame& sensed) {
  const GrayImage* left = GrayImageOf(sensed, kLeftCamera);
  const GrayImage* right = GrayImageOf(sensed, kRightCamera);
  if (!asked_at_ || (!left && !right)) return std::nullopt;
  return StereoImages{left ? *left : Dark(*right), right ? *right : Dark(*left)};
}

LocateOutput AxelMachine::Locate(const StereoImages& images) {
  LocateHints hints = HintsFrom(senses_);
  hints.camera_turn = camera_turn_.belief();
  LocateOutput seen = locator_(images, hints);
  ++belief_.sighting_count;
  belief_.last_sighting = seen.report;
  return seen;
}

std::optional<Event> AxelMachine::Judge(const StereoImages& images) {
  const LocateOutput seen = Locate(images);
  auto ruling = SightingJudge::Ruling::kRejected;
  if (seen.sighting) {
    ruling = judge_.Judge(*seen.sighting, &senses_);
    belief_.note = judge_.why();
  } else {
    belief_.note = std::string("not located: ") + seen.report.reason;
  }
  if (ruling == SightingJudge::Ruling::kLookAgain) {
    look_from_ = senses_.now();
    return std::nullopt;
  }
  if (ruling == SightingJudge::Ruling::kAccepted) {
    camera_turn_.Take(*seen.sighting);
    attempts_ = 0;
    seeker_ = Seeker(options_.search);
    if (taut_ && !senses_.filter().TetherKnown()) senses_.UseTether(0.0);
    if (phase_ == Phase::kRecheck) return AtTheMouth();
    return TetherAbeam() ? Event::kTetherAbeam : AfterSighting();
  }
  // At the mouth the marks may be too near to be seen (Tsai et al., II): the last estimate decides.
  return phase_ == Phase::kRecheck ? AtTheMouth() : Event::kNotSeen;
}

Event AxelMachine::AfterSighting() {
  // A recovery that did not come out, or a search that ended in the cone: the way is in.
  const double inside_m = -TipOf(driving_.geometry(), senses_.pose()).gap_m;
  if (inside_m > options_.mate.inside_m && recoveries_inside_++ < options_.limit.recoveries) {
    belief_.note = "tip is in the cone";
    return Event::kInside;
  }
  const Event event = driving_.PlanNext(senses_);
  if (event == Event::kGoRecover) return Recover(event, "misaligned");
  return driving_.legs() > options_.limit.plans ? Event::kLimitReached : event;
}

Event AxelMachine::AtTheMouth() {
  if (driving_.PlanEntry(senses_)) return Event::kGoMate;
  return Recover(Event::kGoRecover, "misaligned at the mouth");
}

Event AxelMachine::Recover(Event event, const std::string& why) {
  belief_.note = why;
  if (driving_.recoveries() >= options_.limit.recoveries) return Event::kLimitReached;
  driving_.PlanBack(senses_);
  return event;
}

std::optional<Event> AxelMachine::Drive(Commands* commands) {
  const LegDriver::Status status = driving_.Drive(&senses_, commands);
  // A body far from level is tumbling: the arm motor could only make it worse.
  const bool may_level = !driving_.paused() && std::abs(senses_.pitch_rad()) < Radians(45.0);
  if (may_level) arm_.Level(senses_);
  if (driving_.paused()) belief_.note = "arm lifted: reeling in";
  if (StopsAbeam()) {
    belief_.note = "tether abeam";
    seeking_ = true;  // so that it is pulled first
    return Event::kArrived;
  }
  if (status == LegDriver::Status::kUnderWay) return std::nullopt;
  if (status == LegDriver::Status::kFellShort) belief_.note = "leg fell short";
  return Event::kArrived;
}

// On sand a rover that drives with the tether abeam tips its arm over.
bool AxelMachine::StopsAbeam() const {
  const bool on_leg = phase_ == Phase::kApproach || phase_ == Phase::kAlign;
  if (!on_leg || turning_pulls_ >= options_.search.turning_pulls) return false;
  const SearchKnowledge known = Known();
  return std::abs(known.tether_rad) > options_.search.abeam_rad &&
         PullFirst(known, options_.search);
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

SearchKnowledge AxelMachine::Known() const {
  const Pose2 X_DR = senses_.pose();
  const PlanGeometry& geometry = driving_.geometry();
  const TipPlace tip = TipOf(geometry, X_DR);
  return {SeesBoard(geometry, options_.look, X_DR), BoardBearing(geometry, X_DR),
          std::hypot(tip.gap_m, tip.offset_m), TetherAngle(geometry, X_DR)};
}

// In the middle of its arcs the rover has the tether aside, too. So this counts only where it finds
// the board, and a tether that does not turn it is not pulled for ever.
bool AxelMachine::TetherAbeam() {
  return seeking_ && PullFirst(Known(), options_.search) &&
         turning_pulls_++ < options_.search.turning_pulls;
}

void AxelMachine::BeginSearch() {
  seeking_ = true;
  search_.reset();
  if (senses_.filter().located()) search_ = NextSearchAction(attempts_++, Known(), options_.search);
  if (!search_)
    search_ = seeker_.Next(
        {senses_.yaw_rad(), senses_.reeled_m(), senses_.rolled_m(), senses_.elevation_rad()});
  if (!search_ || search_->move != SearchMove::kAdvance) return;
  driving_.PlanAhead(senses_, search_->amount);
  const DriveOptions& drive = options_.drive;
  driving_.Start({drive.approach_m_s, drive.reverse_m_s, drive.steering}, senses_.now());
}

std::optional<Event> AxelMachine::Search(Commands* commands) {
  if (!search_) return GoBlind("board not found");
  if (InPhase() > options_.search.move_limit) return Event::kArrived;
  switch (search_->move) {
    case SearchMove::kAgain:
      return Event::kArrived;
    case SearchMove::kTilt:
      return Level(search_->amount, commands);
    case SearchMove::kTurn:
      return ArrivedIf(TurnInPlace(nominal_, options_, search_->amount, TurnedHere(), commands));
    case SearchMove::kReel:
      ReelNearer(nominal_, options_.tether, commands);
      return ArrivedIf(Stuck() || ReeledHere() >= search_->amount ||
                       RolledHere() >= search_->amount ||
                       RolledHere() <= -options_.search.backwards_m ||
                       std::abs(TurnedHere()) >= options_.search.pull_turn_rad);
    case SearchMove::kReverse:
      return ArrivedIf(
          ReverseStraight(nominal_, options_, search_->amount, RolledHere(), commands));
    case SearchMove::kAdvance:
      return Drive(commands);
    case SearchMove::kBackUp:
      return Recover(Event::kGoRecover, "board lost near the station");
  }
  return std::nullopt;
}

// A rover that knows from before that it stands aside of the cone would jam there.
Event AxelMachine::GoBlind(const std::string& why) {
  belief_.note = why;
  const Pose2 X_DR = senses_.pose();
  const bool aside =
      senses_.filter().located() && std::abs(std::atan2(X_DR.y, X_DR.x)) > options_.haul.aside_rad;
  if (aside || hauls_++ >= options_.haul.tries) return Event::kLimitReached;
  return Event::kGoBlind;
}

// The cone that holds the arm tells the rover where it is. The reel-in then checks that it is
// seated.
std::optional<Event> AxelMachine::HaulIn(Commands* commands) {
  const Haul::Status status = haul_.Step(senses_, commands);
  if (status == Haul::Status::kUnderWay) return std::nullopt;
  if (status == Haul::Status::kLoose) {
    belief_.note += ", and the tether does not lead into the cone";
    return Event::kLimitReached;
  }
  senses_.filter().Restart(SeatedFix(nominal_));
  return Event::kArrived;
}

std::optional<Event> AxelMachine::Reel(Commands* commands) {
  if (reel_in_.Step(senses_, commands) == ReelIn::Status::kUnderWay) return std::nullopt;
  return Event::kReeledIn;
}

// Where the reel-in stopped the rover draws the tether taut, brakes the spool, under which nothing
// may slip, and takes a picture.
std::optional<Event> AxelMachine::Confirm(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, options_.drive, InPhase(), commands);
  if (!Steadied(commands)) return std::nullopt;
  const bool looked = LookedAtHome(sensed, commands);
  const bool waited = senses_.now() - braked_->since >= options_.mate.confirm_time;
  return looked && waited ? std::optional<Event>(RuleHome()) : std::nullopt;
}

bool AxelMachine::Steadied(Commands* commands) {
  if (braked_) return true;
  Spool(commands) = Winch(nominal_, options_.mate.taut_m_s, options_.mate.taut_tension_n,
                          options_.tether.accel_rad_s2);
  const bool waited = InPhase() >= options_.drive.stop_time + options_.tether.taut_after;
  const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
  const bool still_enough = waited && still >= options_.tether.taut_after;
  if (!still_enough && InPhase() < options_.mate.taut_limit) return false;
  braked_ = Braked{.since = senses_.now(), .reeled_m = senses_.reeled_m()};
  Spool(commands) = {};
  return true;
}

bool AxelMachine::LookedAtHome(const SensorFrame& sensed, Commands* commands) {
  if (braked_->looked) return true;
  if (const std::optional<StereoImages> images = Arrived(sensed)) {
    const LocateOutput seen = Locate(*images);
    braked_->looked = true;
    if (!seen.sighting) return true;
    judge_.NewStop();
    judge_.Judge(*seen.sighting, &senses_);
    const double depth_m = DepthBySighting(nominal_, seen.sighting->X_RB, senses_.arm_rad());
    // Deeper than the floor is nonsense.
    if (depth_m <= nominal_.seat_depth_m + options_.mate.over_reel_m) braked_->depth_m = depth_m;
    return true;
  }
  if (!asked_at_) {
    commands->take_images = {kLeftCamera, kRightCamera};
    asked_at_ = senses_.now();
  }
  braked_->looked = senses_.now() - *asked_at_ >= options_.mate.picture_limit;
  return braked_->looked;
}

Event AxelMachine::RuleHome() {
  SeatKnowledge known{.depth_by_drum_m = reel_in_.DepthByDrum(senses_),
                      .depth_by_picture_m = braked_->depth_m};
  if (reel_in_.wiggles() > 0) known.taken_up_by_push_m = reel_in_.taken_up_m(senses_);
  SeatRuling ruling = RuleSeat(known, nominal_.seat_depth_m, options_.mate);
  const double slipped = std::abs(senses_.reeled_m() - braked_->reeled_m);
  if (slipped > options_.mate.confirm_slip_m) ruling = SeatRuling::kShort;
  belief_.note = known.depth_by_picture_m
                     ? "tip " + Fixed(*known.depth_by_picture_m, 3) + " m deep by its picture"
                     : "tip " + Fixed(known.depth_by_drum_m, 3) + " m deep by the drum";
  if (ruling == SeatRuling::kSeated) return Event::kSteady;
  if (reel_in_.wiggles() < options_.mate.wiggles) return Event::kStopsShort;
  return Recover(Event::kStuck, "does not go in");
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
  driving_.Enter(phase, senses_);
  braked_.reset();
  if (phase != Phase::kLook) taut_ = false;
  if (phase == Phase::kLook || phase == Phase::kRecheck) judge_.NewStop();
  if (phase == Phase::kSearch) BeginSearch();
  if (phase == Phase::kRight) righting_.Begin(senses_);
  if (phase == Phase::kHaul) haul_.Begin(senses_);
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

}  // namespace

std::unique_ptr<Controller> MakeAxelMachine(const Nominal& nominal, const AxelOptions& options,
                                            Locator locator) {
  return std::make_unique<AxelMachine>(nominal, options, std::move(locator));
}

}  // namespace dockyard::axel
