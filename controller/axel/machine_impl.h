// The state of the docking controller: one class whose parts stand in files of their own.
// machine.cc steps through the phases, machine_looks.cc stands still and looks, machine_moving.cc
// looks under way, machine_search.cc finds the board or the way without it, machine_excursion.cc
// goes out of the cone first, machine_mating.cc seats the tip.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "controller/axel/bracket.h"
#include "controller/axel/driving.h"
#include "controller/axel/excursion.h"
#include "controller/axel/felt_rocks.h"
#include "controller/axel/haul.h"
#include "controller/axel/machine.h"
#include "controller/axel/mating.h"
#include "controller/axel/moving_looks.h"
#include "controller/axel/phases.h"
#include "controller/axel/righting.h"
#include "controller/axel/search.h"
#include "controller/axel/seeker.h"
#include "controller/axel/senses.h"
#include "controller/axel/sighting.h"
#include "controller/axel/tether_pull.h"
#include "controller/base/check.h"
#include "controller/motion/limits.h"

namespace dockyard::axel {

class AxelMachine final : public Controller {
 public:
  AxelMachine(const Nominal& nominal, const AxelOptions& options, Locator locator)
      : nominal_(nominal),
        options_(options),
        locator_(std::move(locator)),
        senses_(nominal, options),
        driving_(nominal, options),
        felt_rocks_(nominal.track_m, options.felt_rocks, RockLimits{}),
        arm_(nominal, options.arm),
        righting_(nominal, options.righting),
        entry_(nominal, options),
        reel_in_(nominal, options),
        pull_(nominal, options),
        haul_(nominal, options),
        judge_(options.look, nominal.X_DB),
        looks_(options, nominal),
        bracket_(options.bracket, nominal),
        seeker_(options.search),
        still_(options.tether.still_m) {
    DOCKYARD_CHECK(locator_ != nullptr);
    belief_.phase = Name(phase_);
    belief_.values = {{"tether_length_m", 0.0}, {"recoveries", 0.0}, {"rightings", 0.0}};
  }

  Commands Step(const SensorFrame& sensed) override {
    senses_.Update(sensed);
    if (!started_) Enter(nominal_.excursion_m > 0.0 ? Phase::kUndock : Phase::kTighten);
    started_ = true;
    Commands commands = BrakedCommands();
    FeelRocks();
    if (TurnedOver()) Change(Right());
    const std::optional<Event> event = Act(sensed, &commands);
    if (phase_ != Phase::kRight) {
      commands.motors[static_cast<std::size_t>(Motor::kArm)] = arm_.Hold(senses_);
    }
    if (event) Change(*event);
    commands.verdict = phase_ == Phase::kDocked    ? Verdict::kDone
                       : phase_ == Phase::kGivenUp ? Verdict::kGivenUp
                                                   : Verdict::kUnderWay;
    FillBelief();
    KeepLimits(nominal_.motors, &commands);
    return commands;
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

  std::optional<Event> Act(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Tighten(Commands* commands);
  std::optional<Event> Look(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Drive(Commands* commands);
  std::optional<Event> Search(Commands* commands);
  std::optional<Event> Level(double target_pitch_rad, Commands* commands);
  std::optional<Event> Reel(Commands* commands);
  std::optional<Event> Confirm(const SensorFrame& sensed, Commands* commands);
  bool Steadied(Commands* commands);
  bool TautAgain(Commands* commands);
  bool LookedAtHome(const SensorFrame& sensed, Commands* commands);
  Event RuleHome();
  std::optional<Event> TurnBack(Commands* commands);

  void LookUnderWay(const SensorFrame& sensed, Commands* commands);
  bool GoesOn(LegDriver::Status status) const;

  std::optional<StereoImages> Arrived(const SensorFrame& sensed);
  LocateOutput Locate(const StereoImages& images);
  void Tell(const LocateOutput& seen);
  std::optional<Event> LookBracketed(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Judge(const LocateOutput& seen);
  Event AfterSighting();
  Event AtTheMouth();
  Event Misaligned(const std::string& why);
  Event Recover(Event event, const std::string& why);
  void FeelRocks();
  bool TurnedOver();
  Event Right();
  void BeginSearch();
  SearchKnowledge Known() const;
  bool TetherAbeam();
  bool StopsAbeam() const;
  Event GoBlind(const std::string& why);
  std::optional<Event> HaulIn(Commands* commands);
  void BeginExcursion();
  std::optional<Event> GoOut(double way_m, Commands* commands);
  void BeginReturn();

  void Change(Event event);
  void Enter(Phase phase);
  void FillBelief();

  const Nominal nominal_;
  const AxelOptions options_;
  const Locator locator_;
  Senses senses_;
  Driving driving_;
  FeltRocks felt_rocks_;
  ArmLevel arm_;
  Righting righting_;
  Entry entry_;
  ReelIn reel_in_;
  TetherPull pull_;
  Haul haul_;
  SightingJudge judge_;
  MovingLooks looks_;
  Bracket bracket_;
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
  bool held_ = false;               // the last leg made no way
  std::optional<Tick> over_since_;  // turned over

  // Undocking and going out: how it stood in the socket, and what the spool then pulls with.
  double reeled_seated_m_ = 0.0, rolled_seated_m_ = 0.0, yaw_seated_rad_ = 0.0;
  double outward_tension_n_ = 0.0;
  bool returns_ = false;  // a way back has been planned

  // Tightening.
  std::optional<Tick> levelling_since_;
  bool taut_ = false;
  // Taking sightings.
  Tick look_from_ = 0;
  std::optional<Tick> asked_at_;
  int asks_ = 0;           // in a row without an answer
  Tick answer_limit_ = 0;  // the patience with which the last pair came
  // Searching.
  int attempts_ = 0, turning_pulls_ = 0, hauls_ = 0, recoveries_inside_ = 0;
  bool seeking_ = true;  // it has not driven since the board was lost
  std::optional<SearchAction> search_;
  // Confirming: when the spool was braked, where it stood, and what the picture then shows.
  struct Braked {
    Tick since = 0;
    double reeled_m = 0.0;
    bool looked = false;
    std::optional<TipSeen> tip{};
    std::optional<Straighten> straighten{};
    std::optional<Tick> taut_from{}, again{};  // after that: drawn taut, braked
  };
  std::optional<Braked> braked_;
};

}  // namespace dockyard::axel
