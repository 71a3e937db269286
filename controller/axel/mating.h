// The end of a docking: reels the tip in, finds out by a picture or by a push
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

/// What the rover knows at its stop.
struct SeatKnowledge {
  double depth_by_drum_m = 0.0;                // since the last picture before the mouth
  std::optional<double> depth_by_picture_m{};  // none: no picture, or the board is not found in it
  std::optional<double> taken_up_by_push_m{};  // while it was pushed to and fro; none: not pushed
};
enum class SeatRuling {
  kSeated,
  kShort,     // not seated
  kUnproven,  // without a picture: push first
};
/// Whether the tip is on the socket's floor. A picture decides alone, as it is right to millimetres
/// there. Without one the drum's count must be deep enough, and a push to each side must not let
/// the tether in any further.
SeatRuling RuleSeat(const SeatKnowledge& known, double seat_depth_m, const MateOptions& options);

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
  /// Goes on after a stop: first to and fro, each time harder than the last.
  void Wiggle(const Senses& senses);

  /// Sets the commands of wheels and spool. Whether it is over: nothing more comes in, or more came
  /// in than a tip on the tether's end lets in.
  bool Step(const Senses& senses, Commands* commands);

  double DepthByDrum(const Senses& senses) const;
  int wiggles() const { return wiggles_; }
  /// Tether that the last wiggle took up [m].
  double taken_up_m(const Senses& senses) const { return senses.reeled_m() - at_wiggle_m_; }

 private:
  void Pull(Tick still, Commands* commands) const;
  void TurnToAndFro(Tick since, Commands* commands) const;

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
