// Brings a rover that has turned over back to driving: body upright, arm ahead of the axle.
//
// Arm and body turn about the axle by any angle, and gravity lays the arm's tip on the ground ahead
// or behind. With the wheels free the tip stays there and the arm's motor turns the body. With the
// wheels braked the body stands with them and the motor swings the arm over the top. Before that
// the arm is laid against the body's front, so that the body's weight, which is behind the axle,
// is across the axle from the arm's. The spool runs free: an arm that turns against the body winds
// tether on the drum or off it, and the tip comes up to two arm's lengths nearer or goes as far.
//
// Where that fails, the wheels have dug in and the housing lies on the ground. The rover then
// drives some way from the tip, which its wheels press down meanwhile, and tries again.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"
#include "controller/io/commands.h"

namespace dockyard::axel {

class Righting {
 public:
  enum class Status { kUnderWay, kDone, kFailed };

  Righting(const Nominal& nominal, const RightingOptions& options)
      : nominal_(nominal), options_(options) {}

  /// Starts anew at these readings.
  void Begin(const Senses& senses);
  /// Sets the commands of all motors. kFailed: still turned over after all tries.
  Status Step(const Senses& senses, Commands* commands);

  /// Each control period but while it is righted: whether the arm has gone over the top for so long
  /// that it does not swing back by itself. A rover at rest has turned over as well if its
  /// body is not upright.
  bool TurnedOver(const Senses& senses, bool at_rest);

  /// Whether the body stands upright enough to look and drive.
  static bool Upright(const Senses& senses, const RightingOptions& options) {
    return std::abs(senses.pitch_rad()) <= options.upright_rad;
  }

 private:
  enum class Stage { kRest, kCounter, kSwing, kTurn, kLeave };

  void Enter(Stage stage, const Senses& senses);
  bool Rested(const Senses& senses);
  /// How far the arm still has to turn over the top, tip-down positive [rad].
  double ToSwing(const Senses& senses) const;
  MotorCommand ArmTo(double arm_rad, double speed_rad_s) const;
  bool TooLong(const Senses& senses) const { return senses.now() > deadline_; }

  Nominal nominal_;
  RightingOptions options_;
  Stage stage_ = Stage::kRest;
  Tick deadline_ = 0, slow_since_ = 0;
  double held_rad_ = 0.0;  // arm, while at rest
  int moves_ = 0;
  bool left_ = false;  // driven off before the next move
  std::optional<Tick> over_since_;
};

}  // namespace dockyard::axel
