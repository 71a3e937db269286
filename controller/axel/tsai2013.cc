// The controller as Tsai, Nesnas and Zarzhitsky (2013) published it, with its known faults: the
// last sighting alone is the pose, arcs are driven open loop, the tether follows a linear law, and
// nothing tells that the arm is seated.
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
#include "controller/axel/tsai2013_stop.h"
#include "controller/motion/limits.h"

namespace dockyard::axel {
namespace {

enum class Phase { kStop, kDrive, kReel, kDocked, kGivenUp };

const char* Name(Tsai2013Step step) {
  switch (step) {
    case Tsai2013Step::kApproach:
      return "approach";
    case Tsai2013Step::kAlign:
      return "align";
    case Tsai2013Step::kMate:
      return "mate";
    case Tsai2013Step::kRecover:
      return "recover";
    case Tsai2013Step::kReel:
      break;
  }
  return "reel";
}

class Tsai2013 final : public Controller {
 public:
  Tsai2013(const Nominal& nominal, Locator locator)
      : nominal_(nominal),
        options_(nominal.tsai2013),
        locator_(std::move(locator)),
        geometry_(PlanGeometryOf(nominal)),
        senses_(nominal, {}),
        arm_(nominal, {}) {
    belief_.phase = "tighten";
    belief_.values = {{"tether_length_m", 0.0}, {"recoveries", 0.0}};
  }

  Commands Step(const SensorFrame& sensed) override {
    senses_.Update(sensed);
    if (!stop_ && phase_ == Phase::kStop) Enter(Phase::kStop);
    Commands commands = BrakedCommands();
    if (const std::optional<Phase> next = Act(sensed, &commands)) Enter(*next);
    commands.motors[static_cast<std::size_t>(Motor::kArm)] = arm_.Hold(senses_);
    commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDone
                       : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                   : Verdict::kUnderWay;
    belief_.values[1].value = recoveries_;
    KeepLimits(nominal_.motors, &commands);
    return commands;
  }

  const Belief& belief() const override { return belief_; }

 private:
  std::optional<Phase> Act(const SensorFrame& sensed, Commands* commands);
  std::optional<Phase> Stop(const SensorFrame& sensed, Commands* commands);
  std::optional<Phase> Take(const StereoImages& images);
  std::optional<Phase> Blind(const std::string& why);
  std::optional<Phase> Drive(const SensorFrame& sensed, Commands* commands);
  std::optional<Phase> Reel(const SensorFrame& sensed, Commands* commands);
  Phase Plan();
  void Enter(Phase phase);

  const Nominal nominal_;
  const Tsai2013Options options_;
  const Locator locator_;
  const PlanGeometry geometry_;
  Senses senses_;
  ArmLevel arm_;

  Phase phase_ = Phase::kStop;
  Tick entered_ = 0;
  Belief belief_;
  int recoveries_ = 0, blind_looks_ = 0;
  std::optional<Tsai2013Stop> stop_;
  Tsai2013Plan plan_;
  std::optional<OpenLoopArcs> arcs_;
  std::optional<double> reel_to_rad_;
};

std::optional<Phase> Tsai2013::Act(const SensorFrame& sensed, Commands* commands) {
  switch (phase_) {
    case Phase::kStop:
      return Stop(sensed, commands);
    case Phase::kDrive:
      return Drive(sensed, commands);
    case Phase::kReel:
      return Reel(sensed, commands);
    case Phase::kDocked:
    case Phase::kGivenUp:
      break;
  }
  return std::nullopt;  // brakes: the default of Commands
}

std::optional<Phase> Tsai2013::Stop(const SensorFrame& sensed, Commands* commands) {
  switch (stop_->Step(senses_, sensed, &arm_, commands)) {
    case Tsai2013Stop::Status::kTightening:
      break;
    case Tsai2013Stop::Status::kLooking:
      belief_.phase = "look";
      break;
    case Tsai2013Stop::Status::kImages:
      return Take(stop_->images());
    case Tsai2013Stop::Status::kNoImages:
      return Blind("no images");
  }
  return std::nullopt;
}

// At the end of the mating "the fiducial markers are too close to be identified" (II): there the
// sighting before it stands.
std::optional<Phase> Tsai2013::Blind(const std::string& why) {
  belief_.note = why;
  if (++blind_looks_ < options_.blind_looks) return std::nullopt;
  if (plan_.step != Tsai2013Step::kMate) return Phase::kGivenUp;
  plan_ = {Tsai2013Step::kReel, {}};
  return Phase::kReel;
}

std::optional<Phase> Tsai2013::Take(const StereoImages& images) {
  // Without the attitude: what the paper's rover knows of it is that the board hangs upright.
  const LocateOutput seen = locator_(images, LocateHints{});
  ++belief_.sighting_count;
  belief_.last_sighting = seen.report;
  if (!seen.sighting) return Blind(std::string("not located: ") + seen.report.reason);
  blind_looks_ = 0;
  belief_.note = "board seen";
  belief_.located = true;
  const BoardFix fix =
      LevelSighting(seen.sighting->X_RB, senses_.imu(), nominal_.X_DB, senses_.ground());
  belief_.X_DR = PoseOf(fix, nominal_.X_DB);
  return Plan();
}

Phase Tsai2013::Plan() {
  plan_ = PlanTsai2013(geometry_, options_, belief_.X_DR);
  if (plan_.step == Tsai2013Step::kRecover) {
    ++recoveries_;
    belief_.note = "misaligned";
  }
  belief_.plan = Planned(plan_.arcs, belief_.X_DR);
  ++belief_.plan_count;
  return plan_.step == Tsai2013Step::kReel ? Phase::kReel : Phase::kDrive;
}

std::optional<Phase> Tsai2013::Drive(const SensorFrame& sensed, Commands* commands) {
  arm_.Level(senses_);
  if (!arcs_->Drive(sensed, commands)) return std::nullopt;
  belief_.X_DR = Advance(belief_.X_DR, plan_.arcs);  // as it was planned
  return Phase::kStop;
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
  const Tick in_phase = senses_.now() - entered_;
  const double seconds = options_.patience * options_.reel_in_m / options_.reel_m_s;
  const bool late = in_phase >= static_cast<Tick>(seconds / kTickSeconds) + 2 * options_.lag;
  const bool reeled = std::abs(*reel_to_rad_ - angle_rad) * nominal_.drum_radius_m < 1e-3;
  return reeled || late ? std::optional<Phase>(Phase::kDocked) : std::nullopt;
}

void Tsai2013::Enter(Phase phase) {
  phase_ = phase;
  entered_ = senses_.now();
  stop_.reset();
  arcs_.reset();
  reel_to_rad_.reset();
  belief_.phase = phase == Phase::kStop      ? "tighten"
                  : phase == Phase::kDocked  ? "docked"
                  : phase == Phase::kGivenUp ? "given_up"
                                             : Name(plan_.step);
  if (phase == Phase::kStop) stop_.emplace(nominal_);
  if (phase != Phase::kDrive) return;
  const bool mates = plan_.step == Tsai2013Step::kMate;
  arcs_.emplace(nominal_,
                OpenLoopOptions{.speed_m_s = mates ? options_.mate_m_s : options_.drive_m_s,
                                .wheel_accel_rad_s2 = options_.wheel_accel_rad_s2,
                                .patience = options_.patience,
                                .lag = options_.lag},
                plan_.arcs, TetherShortening(nominal_.arm_length_m, belief_.X_DR, plan_.arcs));
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
  return std::make_unique<Tsai2013>(nominal, std::move(locator));
}

}  // namespace dockyard::axel
