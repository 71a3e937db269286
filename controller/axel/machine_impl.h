// The docking controller: a state machine over its senses, the legs that it drives and what finds
// the board. machine.cc steps through the phases, machine_looks.cc takes sightings at rest,
// machine_moving.cc under way, machine_search.cc finds the board or does without it,
// machine_mating.cc seats the tip.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "controller/axel/board_search.h"
#include "controller/axel/driving.h"
#include "controller/axel/excursion.h"
#include "controller/axel/felt_rocks.h"
#include "controller/axel/haul.h"
#include "controller/axel/machine.h"
#include "controller/axel/mating.h"
#include "controller/axel/moving_looks.h"
#include "controller/axel/phases.h"
#include "controller/axel/righting.h"
#include "controller/axel/seat_check.h"
#include "controller/axel/senses.h"
#include "controller/axel/sighting.h"
#include "controller/axel/stop_sighting.h"

namespace dockyard::axel {

class AxelMachine final : public Controller {
 public:
  AxelMachine(const Nominal& nominal, const AxelOptions& options, Locator locator);
  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }

 private:
  /// What was tried already, in the whole run.
  struct Tries {
    int rightings = 0, blind = 0, recoveries_inside = 0;
  };

  std::optional<Event> Act(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Tighten(Commands* commands);
  std::optional<Event> Look(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> Drive(Commands* commands);
  std::optional<Event> ComeOut(Commands* commands);
  std::optional<Event> Search(Commands* commands);
  std::optional<Event> Level(double target_pitch_rad, Commands* commands);
  std::optional<Event> Confirm(const SensorFrame& sensed, Commands* commands);
  std::optional<Event> HaulIn(Commands* commands);
  std::optional<Event> GoOut(double distance_m, Commands* commands);
  std::optional<Event> TurnBack(Commands* commands);
  std::optional<Event> TurnedOver();
  void FeelRocks();

  Locator Located();
  void Tell(const SightingReport& sighting);
  void LookUnderWay(const SensorFrame& sensed, Commands* commands);
  bool GoesOn(LegDriver::Status status) const;
  SearchKnowledge Known() const;
  std::optional<Event> Judge(const LocateOutput& seen);
  Event AfterSighting();
  Event AtTheMouth();
  Event Misaligned(const std::string& why);
  Event Recover(Event event, const std::string& why);
  Event GoBlind(const std::string& why);

  Tick InPhase() const { return senses_.now() - entered_->tick; }
  void Enter(Phase phase);
  void DriveOn(double distance_m);
  void FillBelief();

  const Nominal nominal_;
  const AxelOptions options_;
  Perception perception_;
  Senses senses_;
  Driving driving_;
  ArmLevel arm_;
  FeltRocks felt_rocks_;
  Righting righting_;
  MovingLooks looks_;
  StopSighting stop_;
  SightingJudge judge_;
  BoardSearch search_;
  Entry entry_;
  ReelIn reel_in_;
  SeatCheck seat_check_;
  Haul haul_;
  Excursion excursion_;
  StillWatch still_;

  Phase phase_ = Phase::kTighten;
  std::optional<Moment> entered_;     // the phase
  std::optional<Moment> levelling_;   // begun then, with the tether taut
  bool taut_ = false, held_ = false;  // the tether; the last leg made no way
  Tries tries_;
  Belief belief_;
};

}  // namespace dockyard::axel
