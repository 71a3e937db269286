// The end of a docking: reels the tip in, finds out by an image or by a push
// whether it is seated, and wiggles an arm that stopped short.
#pragma once

#include <optional>

#include "controller/axel/leg.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"

namespace dockyard::axel {

/// How deep the tip is behind the mouth [m], by a sighting and the arm's encoder alone: neither
/// wheels nor tether nor inertial unit come in. The board stands fixed to the cone, so a station
/// that leans or has been pushed does not matter.
double DepthBySighting(const Nominal& nominal, const Pose3& X_RB, double arm_rad);

/// How far the arm leans to a side of the cone's axis [rad], positive to D's +y, from the same two
/// alone.
double AskewBySighting(const Nominal& nominal, const Pose3& X_RB, double arm_rad);

/// What an image at the rover's stop shows.
struct TipSeen {
  double depth_m = 0.0;
  double askew_rad = 0.0;
};
/// What the rover knows at its stop.
struct SeatKnowledge {
  double depth_by_drum_m = 0.0;                // since the last image before the mouth
  std::optional<TipSeen> by_image{};           // none: no image, or the board is not found in it
  std::optional<double> taken_up_by_push_m{};  // while it was pushed to and fro; none: not pushed
};
enum class SeatRuling {
  kSeated,
  kShort,     // not seated
  kAskew,     // on the floor, but the arm leans by more than its play
  kUnproven,  // without an image: push first
};
/// Whether the tip is on the socket's floor. An image decides alone, as it is right to millimetres
/// there: deep enough, and the arm nearly straight. Without one the drum's count must be deep
/// enough, and a push to each side must not let the tether in any further.
SeatRuling RuleSeat(const SeatKnowledge& known, double seat_depth_m, const MateOptions& options);

/// Turns the braked rover by a lean that its image showed, so that the arm is in the middle of
/// its play and not bent against a side.
class Straighten {
 public:
  explicit Straighten(double lean_rad) : lean_rad_(lean_rad) {}
  /// Sets the wheels' commands; whether it is over and the rover at rest again.
  bool Step(const Nominal& nominal, const Senses& senses, const MateOptions& options,
            Commands* commands);
  bool turned() const { return since_.has_value(); }  // or turns
  /// What is left of the lean, by the inertial unit [rad].
  double LeanLeft(const Senses& senses) const;

 private:
  double lean_rad_;
  double yaw_rad_ = 0.0;  // at the start
  std::optional<Tick> since_, stopped_;
};

/// Whether the way into the mouth is over. Its arcs lead half a pitch of the paddles on behind
/// that.
class Entry {
 public:
  Entry(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal), options_(options), still_(options.tether.still_m) {}

  void Begin() { still_.Reset(); }
  /// Over once the tip is as deep as wanted by the estimate and the axle lies level on its paddles,
  /// or once the tip feels the cone.
  bool Over(const Senses& senses, double tip_gap_m);
  bool felt() const { return felt_; }

 private:
  Nominal nominal_;
  AxelOptions options_;
  StillWatch still_;
  bool felt_ = false;
};

/// The spool pulls until it stops, first gently, then as hard as it can. The wheels run along with
/// little thrust: what they do not carry over their paddles the station would have to bear, and
/// they hold the rover back as it rolls off one. Once nothing more comes in they are free, so that
/// they hold the arm against no side of the socket. In a wiggle they turn the rover to and fro,
/// without driving it on.
class ReelIn {
 public:
  ReelIn(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal), options_(options), still_(options.tether.still_m) {}

  /// A new reel-in from a tip this far before the mouth (negative: inside it) by the estimate.
  void Begin(const Senses& senses, double tip_gap_m);
  /// Goes on after a stop: first to and fro, each time harder than the last. The second time the
  /// rover rolls half a pitch of its paddles back and on, so that others carry it.
  void Wiggle(const Senses& senses);

  /// Sets the commands of wheels and spool. Whether it is over: nothing more comes in, or more came
  /// in than a tip on the tether's end lets in.
  bool Step(const Senses& senses, Commands* commands);

  double DepthByDrum(const Senses& senses) const;
  int wiggles() const { return wiggles_; }
  /// Tether that the last wiggle took up [m].
  double taken_up_m(const Senses& senses) const { return senses.reeled_m() - at_wiggle_m_; }

 private:
  void Pull(const Senses& senses, Tick still, Commands* commands) const;
  void TurnToAndFro(Tick since, Commands* commands) const;
  void RollToAndFro(Tick since, Commands* commands) const;

  Nominal nominal_;
  AxelOptions options_;
  StillWatch still_;
  double reeled_at_mouth_m_ = 0.0;
  int wiggles_ = 0;
  double at_wiggle_m_ = 0.0;
  std::optional<Tick> wiggle_since_;
  bool gentle_ = true;
};

}  // namespace dockyard::axel
