// The approach by the tether alone, for a rover that cannot see: the spool draws it to the station
// with free wheels, and a push to each side tells whether the cone holds the arm.
#pragma once

#include "controller/axel/leg.h"
#include "controller/axel/options.h"
#include "controller/axel/pose_filter.h"
#include "controller/axel/senses.h"
#include "controller/axel/tether_pull.h"

namespace dockyard::axel {

/// What a push to each side by the wheels did while the spool pulled.
struct Push {
  double commanded_rad = 0.0;  // from one side to the other
  double turned_rad = 0.0;     // of it
  double taken_up_m = 0.0;     // tether
};
enum class Hold {
  kHeld,    // by the cone, and no more tether comes in
  kDeeper,  // the push let tether in: push again
  kLoose,   // it turns as on open ground, or the arm does not lie as in the socket
};
/// elevation_rad: of the arm.
Hold JudgePush(const Push& push, double elevation_rad, const Nominal& nominal,
               const HaulOptions& options);

/// The pose of a seated rover, as a fix.
BoardFix SeatedFix(const Nominal& nominal);

class Haul {
 public:
  enum class Status {
    kUnderWay,
    kHeld,   // at rest in the cone
    kLoose,  // the spool stalls somewhere else, or drags the station
  };

  Haul(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal),
        options_(options),
        pull_(nominal, options),
        still_(options.tether.still_m),
        slide_(nominal.arm_length_m, options.slide) {}

  void Begin(const Senses& senses);
  Status Step(const Senses& senses, Commands* commands);

 private:
  /// The spool draws until it stalls. Then pushes to the sides let the cone turn the rover into
  /// line, under less tension, so that they do not shift the station. It pulls as hard as the
  /// reel-in does, and pushes again. Held, it eases the tether to the tension of the last check, so
  /// that what the tether stretches does not count as depth.
  enum class Stage { kDraw, kAlign, kPull, kPush, kEase };
  void Enter(Stage stage, const Senses& senses);
  Status JudgeHere(const Senses& senses);

  Nominal nominal_;
  AxelOptions options_;
  TetherPull pull_;
  StillWatch still_;
  SlideWatch slide_;
  Stage stage_ = Stage::kDraw;
  Tick entered_ = 0;
  double reeled_m_ = 0.0;                            // when the stage began
  double leftmost_rad_ = 0.0, rightmost_rad_ = 0.0;  // turned since then
  double yaw_rad_ = 0.0;
  int pushes_ = 0;
};

}  // namespace dockyard::axel
