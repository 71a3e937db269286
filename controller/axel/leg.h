// Drives one leg: path, tether and arm together, with a guard against a lifting arm.
#pragma once

#include <limits>
#include <vector>

#include "controller/axel/drive.h"
#include "controller/axel/senses.h"
#include "controller/axel/tether_observer.h"
#include "controller/io/commands.h"

namespace dockyard::axel {

/// Keeps body and cameras level. The arm motor sets only the angle between body and arm. Tether,
/// gravity and wheel torque decide where the arm lies, so the body follows the angle.
class ArmLevel {
 public:
  ArmLevel(const Nominal& nominal, const ArmOptions& options)
      : nominal_(nominal), options_(options) {}

  /// Moves the wanted angle so that the pitch goes to target_pitch_rad. Call it only while the body
  /// can turn about the axle (wheels driven or free, not braked).
  void Level(const Senses& senses, double target_pitch_rad = 0.0);
  /// Wants the angle that the arm has next.
  void Reset() { wanted_rad_.reset(); }
  /// The arm motor's command: hold the wanted angle.
  MotorCommand Hold(const Senses& senses);

 private:
  Nominal nominal_;
  ArmOptions options_;
  std::optional<double> wanted_rad_;
  Tick last_level_ = -1;
};

class LegDriver {
 public:
  struct Speed {
    double forward_m_s = 0.05, reverse_m_s = 0.05;
    Steering steering{};
    double thrust_n = std::numeric_limits<double>::infinity();  // of the wheels
    bool pays_out = false;  // the spool drives the tether out, so that it does not hold the rover
    bool by_tip = false;  // to the mouth: the tip is steered to the axis, not the axle to the path
  };
  enum class Status { kUnderWay, kArrived, kFellShort, kDigs };

  LegDriver(const Nominal& nominal, const AxelOptions& options, const Pose2& X_DR_start,
            std::vector<Arc> arcs, const Speed& speed, Tick now);

  /// Sets the commands of wheels and spool. Corrects the pose in `senses` by the taut tether.
  Status Drive(Senses* senses, Commands* commands);
  double Remaining() const { return follower_.Remaining(); }  // [m]
  /// The rover against its place on the path: offset to the left, and heading beside the one that
  /// holds it there while it drifts.
  Pose2 Beside(const Pose2& X_DR, double drift) const;
  bool paused() const { return paused_since_.has_value(); }

 private:
  void Guard(const Senses& senses, bool forward);
  double Tension(const Senses& senses, bool forward) const;
  MotorCommand Spool(const Senses& senses, const Twist& twist) const;
  Twist AgainstSlip(const Senses& senses, const Twist& twist) const;
  bool Locked(const Senses& senses);

  Nominal nominal_;
  AxelOptions options_;
  TetherGeometry tether_;
  DigWatch dig_watch_;
  PathFollower follower_;
  Speed speed_;
  Tick deadline_ = 0;
  std::optional<Tick> paused_since_;
  Tick guard_off_until_ = 0;
  std::optional<Tick> spinning_since_;
  Tick locked_until_ = 0;
};

/// The set tension of a rover that drives forwards with the tether this far aside of its arm [N].
double TensionAside(const TetherOptions& options, double aside_rad);
/// Reels slack in up to this tension.
MotorCommand TautWinch(const Nominal& nominal, const TetherOptions& options, double tension_n);
/// Holds the tether with it, and gives way before a rover that rolls off a rock pulls the station
/// along.
MotorCommand HoldingWinch(const Nominal& nominal, const TetherOptions& options, double tension_n);

/// Turns in place until turned_rad reaches amount_rad; returns whether it has. The spool gives way.
bool TurnInPlace(const Nominal& nominal, const AxelOptions& options, double amount_rad,
                 double turned_rad, Commands* commands);
/// Drives straight back until rolled_m, negative backwards, reaches -amount_m; returns whether it
/// has. The spool gives way.
bool ReverseStraight(const Nominal& nominal, const AxelOptions& options, double amount_m,
                     double rolled_m, Commands* commands);
/// Wheels and spool, with at most pull_n, draw the rover ahead, out of a hole that its wheels dug.
void DriveOut(const Nominal& nominal, const AxelOptions& options, double pull_n,
              Commands* commands);
/// Lets the wheels run down, then brakes them.
void StandStill(const Nominal& nominal, const DriveOptions& options, Tick since_stop,
                Commands* commands);

}  // namespace dockyard::axel
