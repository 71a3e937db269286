// The states of the docking and the transitions between them: Tsai et al., Fig. 4 and IV, with the
// search, the recheck at the mouth and the limits that the paper leaves to future work.
#pragma once

#include <optional>

namespace dockyard::axel {

enum class Phase {
  kTighten,    // wheels braked, reel until the tether is taut
  kLook,       // stand still, take an image pair, locate, decide
  kSearch,     // board not seen: tilt, turn, come nearer
  kApproach,   // drive a leg, far away
  kAlign,      // drive a leg onto the cone's axis
  kBackOff,    // reverse because there is no room for the arcs
  kOut,        // ahead out of a hole that the wheels dug
  kRecover,    // reverse to the recovery goal after a failed check
  kMate,       // slowly to the mouth
  kRecheck,    // take one more sighting
  kEnter,      // slowly until the tip is in the mouth
  kReel,       // wheels free, reel in
  kConfirm,    // spool braked, nothing may move
  kHaul,       // cannot see: wheels free, the tether draws it into the cone
  kUndock,     // seated at the start: reverse straight out of the cone
  kExcursion,  // reverse on until it is as far out as told
  kReturn,     // back by dead reckoning to where the board can be seen
  kRight,      // turned over: body upright again, arm ahead
  kDocked,
  kGivenUp,
};
inline constexpr int kPhaseCount = static_cast<int>(Phase::kGivenUp) + 1;

enum class Event {
  kTaut,
  kNotSeen,
  kTetherAbeam,  // seen, but the tether has to turn the rover before it drives
  kGoApproach,
  kGoAlign,
  kGoBackOff,
  kGoMate,      // aligned
  kGoRecover,   // misaligned and too near
  kGoBlind,     // no camera shows the board
  kInside,      // the tip is deep in the cone already
  kArrived,     // the move is over, complete or not
  kDigs,        // the wheels roll, and the rover gets no further
  kReeledIn,    // reeled in as far as asked
  kStopsShort,  // it is not all the way in, and may be with another push
  kStuck,       // it does not go in, or does not stay in
  kSteady,
  kTurnedOver,  // arm behind the axle, or body upside down
  kLimitReached,
};
inline constexpr int kEventCount = static_cast<int>(Event::kLimitReached) + 1;

const char* Name(Phase phase);

/// The phase that follows the event; none when the event means nothing in this phase.
std::optional<Phase> Next(Phase phase, Event event);

}  // namespace dockyard::axel
