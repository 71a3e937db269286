// The spool draws the rover nearer, wheels free, as in the search and without pictures.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"
#include "controller/axel/tether_observer.h"
#include "controller/io/commands.h"

namespace dockyard::axel {

/// Pulls with little tension. Where that stalls the wheels push ahead for a while, over a paddle;
/// where they do not help either, it pulls harder. Where it drags the station it goes on weaker,
/// and the wheels drive along.
class TetherPull {
 public:
  TetherPull(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal),
        options_(options),
        still_(options.tether.still_m),
        slide_(nominal.arm_length_m, options.slide) {}

  void Begin(const Senses& senses);
  /// Whether a pull has dragged the station.
  bool slid() const { return slid_; }
  enum class Status { kPulls, kStalls, kStationSlides };
  /// Sets the commands of wheels and spool. It stalls where nothing helps any more.
  Status Step(const Senses& senses, Commands* commands);

 private:
  enum class Stage { kGentle, kNudge, kHard };
  void Enter(Stage stage, const Senses& senses);

  Nominal nominal_;
  AxelOptions options_;
  StillWatch still_;
  Stage stage_ = Stage::kGentle;
  Tick since_ = 0;
  double reeled_m_ = 0.0;  // when the stage began
  double rolled_m_ = 0.0;  // when the pull began
  SlideWatch slide_;
  bool slid_ = false;    // the station, in a pull
  double most_n_ = 1e9;  // of the tension, since then
};

}  // namespace dockyard::axel
