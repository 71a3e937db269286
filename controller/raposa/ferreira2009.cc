#include "controller/raposa/ferreira2009.h"

#include <cmath>
#include <optional>
#include <string>

#include "controller/motion/arcs.h"
#include "controller/motion/limits.h"
#include "controller/raposa/align_pass.h"
#include "controller/raposa/drive.h"
#include "controller/raposa/ferreira_sight.h"
#include "controller/raposa/odometry.h"
#include "controller/raposa/picture_report.h"
#include "controller/raposa/schemas.h"
#include "controller/raposa/search.h"
#include "controller/raposa/state_choice.h"

namespace dockyard::raposa {
namespace {

/// The parts of the states that last. States 1, 3, 4 and 5 are chosen anew with each frame.
enum class Part {
  kChoose,
  kPass,   // states 7 and 2
  kFinal,  // state 6
  kSettle,
  kDoors,
  kDocked
};

class Ferreira2009 final : public Controller {
 public:
  explicit Ferreira2009(const Nominal& nominal)
      : nominal_(nominal),
        options_(nominal.ferreira_motion),
        lever_m_(-nominal.X_RC.p.x()),
        sight_(nominal),
        odometry_(nominal),
        search_(options_),
        arm_rad_(options_.level_arm_rad) {
    belief_.phase = "start";
    belief_.values = {
        {"state", 0.0}, {"alpha_deg", 0.0}, {"r_m", 0.0}, {"passes", 0.0}, {"band_changes", 0.0}};
  }

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }

 private:
  Twist Act();
  Twist Choose();
  Twist Do(State state);
  Twist Search();
  Twist BlueOnly();
  Twist BeginPass();
  Twist Pass();
  Twist End();
  void LeaveGuide();
  void Enter(Part part);
  void Tell(State state, const std::string& note);
  void Believe(const BeltMotion& motion);
  bool Over(double seconds) const {
    return static_cast<double>(now_ - entered_) * kTickSeconds >= seconds - 1e-9;
  }

  const Nominal nominal_;
  const FerreiraMotion options_;
  const double lever_m_;  // from the camera to the turning centre
  Sight sight_;
  BeltOdometry odometry_;
  WideningSearch search_;
  TurnAboutBlue about_blue_;

  Tick now_ = 0, entered_ = 0;
  Part part_ = Part::kChoose;
  std::optional<State> state_;  // none before the first picture
  BeltMotion motion_;           // since the last call
  std::optional<AlignPass> pass_;
  double last_turn_rad_ = 0.0;         // of the last rotation, to the left
  std::optional<Tick> blue_since_;     // state 4 without a break
  double turned_from_blue_rad_ = 0.0;  // since it was left in doubt
  bool blue_doubted_ = false, lamps_ = false;
  double arm_rad_;
  Twist last_twist_;
  std::string why_;  // the present pass began
  Belief belief_;
};

Commands Ferreira2009::Step(const SensorFrame& sensed) {
  now_ = sensed.tick;
  motion_ = odometry_.Update(sensed);
  // State 6 inhibits further choices (F, C.3): another ellipse is none of its.
  sight_.Look(sensed, part_ == Part::kChoose || part_ == Part::kPass);
  Believe(motion_);
  last_twist_ = Act();
  Commands commands = BrakedCommands();
  SetBelts(nominal_, last_twist_, &commands);
  SetArm(nominal_, arm_rad_, &commands);
  if (part_ == Part::kDoors || part_ == Part::kDocked) {
    CloseDoors(nominal_, options_.close_s, &commands);
  }
  commands.take_images = {kBackCamera};
  commands.switches[kLamps] = lamps_ ? 1 : 0;
  commands.verdict = part_ == Part::kDocked ? Verdict::kDone : Verdict::kUnderWay;
  if (state_) belief_.values[0].value = static_cast<double>(*state_);
  belief_.values[4].value = sight_.band_changes();
  KeepLimits(nominal_.motors, &commands);
  return commands;
}

Twist Ferreira2009::Act() {
  switch (part_) {
    case Part::kChoose:
      return Choose();
    case Part::kPass:
      return Pass();
    case Part::kFinal:
    case Part::kSettle:
    case Part::kDoors:
    case Part::kDocked:
      break;
  }
  return End();
}

// Between two pictures the last speeds go on; a camera that is silent stops the robot.
Twist Ferreira2009::Choose() {
  if (!sight_.fresh()) return sight_.silent() ? Twist{} : last_twist_;
  const MarksSeen& seen = sight_.seen();
  if (seen.pair) search_.End();
  if (seen.orange) blue_doubted_ = false;
  StateCues cues = CuesOf(seen);
  cues.blue = cues.blue && !blue_doubted_;
  const State state = ChooseState(cues, options_);
  if (state != State::kBlueOnly) blue_since_.reset();
  return Do(state);
}

Twist Ferreira2009::Do(State state) {
  const MarksSeen& seen = sight_.seen();
  if (state != State::kAlign) {
    Tell(state, seen.pair ? "pair" : seen.orange ? "ellipse alone" : seen.blue ? "rectangle" : "");
  }
  switch (state) {
    case State::kApproach:
      if (NearGuide(seen, options_)) {
        arm_rad_ = ArmFor(seen, options_);
        lamps_ = true;
      }
      return Approach(seen, options_);
    case State::kAlign:
      return BeginPass();
    case State::kOrangeFar:
      return CreepToOrange(seen, options_);
    case State::kBlueOnly:
      return BlueOnly();
    case State::kNothing:
      return Search();
    case State::kFinal:
      lamps_ = true;
      Enter(Part::kFinal);
      return End();
    case State::kVisualTurn:
      break;  // only a pass begins it
  }
  return {};
}

// It stands still first, as long as the ball about the last ellipse is closed.
Twist Ferreira2009::Search() {
  if (sight_.lost() < nominal_.ferreira_vision.lost_frames) return {};
  LeaveGuide();
  if (!search_.begun()) search_.Begin(last_turn_rad_);
  if (blue_doubted_) {
    turned_from_blue_rad_ += std::abs(motion_.turn_rad);
    if (turned_from_blue_rad_ > 2.0 * nominal_.half_view_rad) blue_doubted_ = false;
  }
  const double rate_rad_s = search_.Step(motion_.turn_rad);
  last_turn_rad_ = rate_rad_s;
  return {0.0, rate_rad_s};
}

Twist Ferreira2009::BlueOnly() {
  if (!blue_since_) {
    blue_since_ = now_;
    about_blue_.Begin();
  }
  if (static_cast<double>(now_ - *blue_since_) * kTickSeconds > options_.doubt_s) {
    blue_doubted_ = true;
    turned_from_blue_rad_ = 0.0;
  }
  const double blue_px = sight_.seen().blue->centre_px().x() - sight_.middle_px().x();
  const double rate_rad_s = about_blue_.Step(blue_px, sight_.half_view_px(), options_);
  last_turn_rad_ = rate_rad_s;
  return {0.0, rate_rad_s};
}

Twist Ferreira2009::BeginPass() {
  LeaveGuide();
  pass_.emplace(nominal_, sight_);
  odometry_.Reset(0.0);
  belief_.values[3].value += 1.0;
  const AlignPlan& plan = pass_->plan();
  const Pose2 X_DR = belief_.X_DR;  // R drives backwards where N drives on
  const Pose2 turned = Advance(X_DR, Arc{0.0, plan.beta_rad});
  belief_.plan = {{X_DR, 0.0, plan.beta_rad},
                  {turned, -plan.way_m, 0.0},
                  {Advance(turned, Arc{-plan.way_m, 0.0}), 0.0, plan.phi_rad}};
  ++belief_.plan_count;
  why_ = sight_.seen().pair->angle.beyond_root ? "no root of (7): 73 deg taken"
                                               : "angle beyond region I";
  Enter(Part::kPass);
  return Pass();
}

Twist Ferreira2009::Pass() {
  const Twist twist = pass_->Step(now_, sight_, last_twist_, &odometry_);
  const AlignPass::Status status = pass_->status();
  Tell(status == AlignPass::Status::kByEye ? State::kVisualTurn : State::kAlign, why_);
  if (status == AlignPass::Status::kLost) Enter(Part::kChoose);
  if (status == AlignPass::Status::kOver) {
    last_turn_rad_ = pass_->plan().phi_rad;
    sight_.Forget();
    search_.End();
    Enter(Part::kChoose);
  }
  return twist;
}

Twist Ferreira2009::End() {
  if (part_ == Part::kFinal && Over(options_.final_s)) Enter(Part::kSettle);
  if (part_ == Part::kSettle && Over(options_.settle_s)) Enter(Part::kDoors);
  if (part_ == Part::kDoors && Over(options_.doors_s)) Enter(Part::kDocked);
  if (part_ == Part::kDocked) belief_.phase = "docked";
  if (part_ != Part::kFinal) return {};
  if (!sight_.fresh() && !sight_.silent()) return last_twist_;
  return FinalApproach(sight_.fresh() ? sight_.seen() : MarksSeen{}, options_);
}

// "In all other states, the arm is kept at a constant position" (F, D): the odometry's gauge holds
// there alone.
void Ferreira2009::LeaveGuide() {
  arm_rad_ = options_.level_arm_rad;
  lamps_ = false;
}

void Ferreira2009::Enter(Part part) {
  part_ = part;
  entered_ = now_;
}

void Ferreira2009::Tell(State state, const std::string& note) {
  state_ = state;
  belief_.phase = Name(state);
  belief_.note = note;
}

void Ferreira2009::Believe(const BeltMotion& motion) {
  const bool pair = sight_.fresh() && sight_.seen().pair.has_value();
  const Pose2 X_DN = pair ? PoseOfN(sight_.Guide(), lever_m_) : Pose2{};
  if (sight_.fresh()) {
    ++belief_.sighting_count;
    belief_.last_sighting = ReportOf(sight_.seen(), X_DN);
  }
  if (pair) {
    belief_.located = true;
    belief_.X_DR = {X_DN.x, X_DN.y, WrapPi(X_DN.heading + kPi)};
    belief_.values[1].value = Degrees(sight_.seen().pair->alpha_rad);
    belief_.values[2].value = sight_.seen().pair->angle.r_m;
  } else if (belief_.located) {
    belief_.X_DR = Advance(belief_.X_DR, Arc{-motion.length_m, motion.turn_rad});
  }
}

}  // namespace

std::unique_ptr<Controller> MakeFerreira2009Controller(const Nominal& nominal) {
  return std::make_unique<Ferreira2009>(nominal);
}

}  // namespace dockyard::raposa
