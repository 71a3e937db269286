// The controller as Tsai, Nesnas and Zarzhitsky (2013) published it, with its known faults: the
// last sighting alone is the pose, arcs are driven open loop, the tether follows a linear law, and
// nothing tells that the arm is seated.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "controller/axel/axel.h"
#include "controller/axel/leg.h"
#include "controller/axel/open_loop.h"
#include "controller/axel/pose_filter.h"
#include "controller/axel/senses.h"
#include "controller/axel/tsai2013_plan.h"

namespace dockyard::axel {
namespace {

enum class Phase { kTighten, kLook, kApproach, kAlign, kMate, kRecover, kReel, kDocked, kGivenUp };

const char* Name(Phase phase) {
  switch (phase) {
    case Phase::kTighten:
      return "tighten";
    case Phase::kLook:
      return "look";
    case Phase::kApproach:
      return "approach";
    case Phase::kAlign:
      return "align";
    case Phase::kMate:
      return "mate";
    case Phase::kRecover:
      return "recover";
    case Phase::kReel:
      return "reel";
    case Phase::kDocked:
      return "docked";
    case Phase::kGivenUp:
      return "given_up";
  }
  return "";
}

Phase PhaseOf(Tsai2013Step step) {
  switch (step) {
    case Tsai2013Step::kApproach:
      return Phase::kApproach;
    case Tsai2013Step::kAlign:
      return Phase::kAlign;
    case Tsai2013Step::kMate:
      return Phase::kMate;
    case Tsai2013Step::kRecover:
      break;
  }
  return Phase::kRecover;
}

class Tsai2013 final : public Controller {
 public:
  Tsai2013(const Nominal& nominal, const Tsai2013Options& options, Locator locator)
      : nominal_(nominal),
        options_(options),
        locator_(std::move(locator)),
        geometry_(PlanGeometryOf(nominal)),
        senses_(nominal, {}),
        arm_(nominal, {}),
        still_(TetherOptions{}.still_m) {
    belief_.values = {{"tether_length_m", 0.0}, {"recoveries", 0.0}};
  }

  Commands Step(const SensorFrame& sensed) override {
    senses_.Update(sensed);
    if (!started_) Enter(Phase::kTighten);
    started_ = true;
    Commands commands = BrakedCommands();
    if (const std::optional<Phase> next = Act(sensed, &commands)) Enter(*next);
    commands.motors[static_cast<std::size_t>(Motor::kArm)] = arm_.Hold(senses_);
    commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDocked
                       : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                   : Verdict::kUnderWay;
    belief_.phase = Name(phase_);
    belief_.values[1].value = recoveries_;
    return WithinLimits(nominal_, commands);
  }

  const Belief& belief() const override { return belief_; }

 private:
  Tick InPhase() const { return senses_.now() - entered_; }
  OpenLoopOptions DriveOptionsOf(Phase phase) const {
    return {.speed_m_s = phase == Phase::kMate ? options_.mate_m_s : options_.drive_m_s,
            .wheel_accel_rad_s2 = options_.wheel_accel_rad_s2,
            .patience = options_.patience,
            .lag = options_.lag};
  }

  std::optional<Phase> Act(const SensorFrame& sensed, Commands* commands);
  std::optional<Phase> Tighten(Commands* commands);
  std::optional<Phase> Level(Commands* commands);
  std::optional<Phase> Look(const SensorFrame& sensed, Commands* commands);
  std::optional<Phase> Take(const StereoImages& images);
  std::optional<Phase> Blind(const std::string& why);
  std::optional<Phase> Drive(const SensorFrame& sensed, Commands* commands);
  std::optional<Phase> Reel(const SensorFrame& sensed, Commands* commands);
  void Plan();
  void Enter(Phase phase);

  const Nominal nominal_;
  const Tsai2013Options options_;
  const Locator locator_;
  const PlanGeometry geometry_;
  Senses senses_;
  ArmLevel arm_;
  StillWatch still_;

  bool started_ = false;
  Phase phase_ = Phase::kTighten;
  Tick entered_ = 0;
  Belief belief_;
  int recoveries_ = 0, blind_looks_ = 0;
  std::optional<Tick> levelling_since_, asked_at_;
  Tsai2013Plan plan_;
  std::optional<OpenLoopArcs> arcs_;
  std::optional<double> reel_to_rad_;
};

std::optional<Phase> Tsai2013::Act(const SensorFrame& sensed, Commands* commands) {
  switch (phase_) {
    case Phase::kTighten:
      return levelling_since_ ? Level(commands) : Tighten(commands);
    case Phase::kLook:
      return Look(sensed, commands);
    case Phase::kApproach:
    case Phase::kAlign:
    case Phase::kMate:
    case Phase::kRecover:
      return Drive(sensed, commands);
    case Phase::kReel:
      return Reel(sensed, commands);
    case Phase::kDocked:
    case Phase::kGivenUp:
      break;
  }
  return std::nullopt;  // brakes: the default of Commands
}

std::optional<Phase> Tsai2013::Tighten(Commands* commands) {
  StandStill(nominal_, {}, InPhase(), commands);
  commands->motors[static_cast<std::size_t>(Motor::kSpool)] =
      Winch(nominal_, options_.tighten_m_s, options_.taut_n + nominal_.spool_friction_n,
            TetherOptions{}.accel_rad_s2);
  const Tick still = still_.Still(senses_.now(), senses_.reeled_m());
  const bool waited = InPhase() >= DriveOptions{}.stop_time + options_.still_after;
  const bool taut = waited && still >= options_.still_after;
  if (!taut && InPhase() < options_.tighten_limit) return std::nullopt;
  if (std::abs(senses_.pitch_rad()) <= options_.look_pitch_rad) return Phase::kLook;
  levelling_since_ = senses_.now();
  return std::nullopt;
}

// "The rover can pitch its cameras independent of the rover's motion" (II): with free wheels the
// arm's motor turns the body about the axle.
std::optional<Phase> Tsai2013::Level(Commands* commands) {
  SetWheels(MotorMode::kFree, commands);
  arm_.Level(senses_);
  const bool level = std::abs(senses_.pitch_rad()) <= 2.0 * ArmOptions{}.dead_band_rad;
  const bool late = senses_.now() - *levelling_since_ >= options_.level_limit;
  return level || late ? std::optional<Phase>(Phase::kLook) : std::nullopt;
}

std::optional<Phase> Tsai2013::Look(const SensorFrame& sensed, Commands* commands) {
  StandStill(nominal_, {}, InPhase(), commands);
  const GrayImage* left = GrayImageOf(sensed, kLeftCamera);
  const GrayImage* right = GrayImageOf(sensed, kRightCamera);
  if (asked_at_ && left && right) {
    asked_at_.reset();
    entered_ = senses_.now();
    return Take({*left, *right});
  }
  if (InPhase() < options_.settle) return std::nullopt;
  if (!asked_at_) {
    commands->take_images = {kLeftCamera, kRightCamera};
    asked_at_ = senses_.now();
  } else if (senses_.now() - *asked_at_ > LookOptions{}.image_limit) {
    asked_at_.reset();
    entered_ = senses_.now();
    return Blind("no images");
  }
  return std::nullopt;
}

std::optional<Phase> Tsai2013::Blind(const std::string& why) {
  belief_.note = why;
  return ++blind_looks_ >= options_.blind_looks ? std::optional<Phase>(Phase::kGivenUp)
                                                : std::nullopt;
}

std::optional<Phase> Tsai2013::Take(const StereoImages& images) {
  LocateHints hints;
  hints.up_R = UpOfStation(senses_.attitude(), false);
  const LocateOutput seen = locator_(images, hints);
  ++belief_.sighting_count;
  belief_.last_sighting = seen.report;
  if (!seen.sighting) return Blind(std::string("not located: ") + seen.report.reason);
  blind_looks_ = 0;
  belief_.note = "board seen";
  belief_.located = true;
  const BoardFix fix =
      LevelSighting(seen.sighting->X_RB, senses_.imu(), nominal_.X_DB, senses_.ground());
  belief_.X_DR = PoseOf(fix, nominal_.X_DB);
  Plan();
  return PhaseOf(plan_.step);
}

void Tsai2013::Plan() {
  plan_ = PlanTsai2013(geometry_, options_, belief_.X_DR);
  if (plan_.step == Tsai2013Step::kRecover) {
    ++recoveries_;
    belief_.note = "misaligned";
  }
  belief_.plan = Planned(plan_.arcs, belief_.X_DR);
  ++belief_.plan_count;
}

std::optional<Phase> Tsai2013::Drive(const SensorFrame& sensed, Commands* commands) {
  arm_.Level(senses_);
  if (!arcs_->Drive(sensed, commands)) return std::nullopt;
  belief_.X_DR = Advance(belief_.X_DR, plan_.arcs);  // as it was planned
  return phase_ == Phase::kMate ? Phase::kReel : Phase::kTighten;
}

// "As of this writing, the rover did not have a sensing capability to confirm the completed
// docking" (IV): the sighting before the mating let it begin, and the reeled length ends it.
std::optional<Phase> Tsai2013::Reel(const SensorFrame& sensed, Commands* commands) {
  SetWheels(MotorMode::kFree, commands);
  const double angle_rad = MotorAngle(nominal_, sensed, Motor::kSpool);
  if (!reel_to_rad_) reel_to_rad_ = angle_rad + options_.reel_in_m / nominal_.drum_radius_m;
  const auto spool = static_cast<std::size_t>(Motor::kSpool);
  commands->motors[spool] = {.mode = MotorMode::kPosition,
                             .target = *reel_to_rad_,
                             .speed_limit_rad_s = options_.reel_m_s / nominal_.drum_radius_m,
                             .accel_rad_s2 = TetherOptions{}.accel_rad_s2,
                             .current_limit_a = nominal_.motors[spool].max_current_a};
  const double seconds = options_.patience * options_.reel_in_m / options_.reel_m_s;
  const bool late = InPhase() >= static_cast<Tick>(seconds / kTickSeconds) + 2 * options_.lag;
  const bool reeled = std::abs(*reel_to_rad_ - angle_rad) * nominal_.drum_radius_m < 1e-3;
  return reeled || late ? std::optional<Phase>(Phase::kDocked) : std::nullopt;
}

void Tsai2013::Enter(Phase phase) {
  phase_ = phase;
  entered_ = senses_.now();
  still_.Reset();
  levelling_since_.reset();
  asked_at_.reset();
  reel_to_rad_.reset();
  arcs_.reset();
  const bool drives = phase == Phase::kApproach || phase == Phase::kAlign ||
                      phase == Phase::kMate || phase == Phase::kRecover;
  if (!drives) return;
  arcs_.emplace(nominal_, DriveOptionsOf(phase), plan_.arcs,
                TetherShortening(nominal_.arm_length_m, belief_.X_DR, plan_.arcs));
}

}  // namespace

std::unique_ptr<Controller> MakeTsai2013Controller(const Nominal& nominal, Locator locator) {
  if (!locator) {
    VisionSettings vision = nominal.vision;
    vision.pipeline = VisionPipeline::kTsai2013;
    locator = [rig = nominal.rig, board = nominal.board, vision](const StereoImages& images,
                                                                 const LocateHints& hints) {
      return LocateBoard(images, rig, board, hints, vision);
    };
  }
  return std::make_unique<Tsai2013>(nominal, Tsai2013Options{}, std::move(locator));
}

}  // namespace dockyard::axel
