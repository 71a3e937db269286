// The spool draws the rover nearer, wheels free, as in the search and without pictures.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"
#include "controller/io/commands.h"

namespace dockyard::axel {

/// Pulls with little tension. Where that stalls the wheels push ahead for a while, over a paddle;
/// where they do not help either, it pulls harder.
class TetherPull {
 public:
  TetherPull(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal), options_(options), still_(options.tether.still_m) {}

  void Begin(const Senses& senses) { Enter(Stage::kGentle, senses); }
  /// Sets the commands of wheels and spool. Whether nothing helps any more.
  bool Step(const Senses& senses, Commands* commands);

 private:
  enum class Stage { kGentle, kNudge, kHard };
  void Enter(Stage stage, const Senses& senses);

  Nominal nominal_;
  AxelOptions options_;
  StillWatch still_;
  Stage stage_ = Stage::kGentle;
  Tick since_ = 0;
  double reeled_m_ = 0.0;  // when the stage began
};

}  // namespace dockyard::axel
