// The phases of Rocky 7's tasks and the transitions between them: one table for each task (Nesnas,
// Maimone and Das 2000, IV and V).
#pragma once

#include <optional>

#include "controller/io/commands.h"
#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

enum class Phase {
  kAim,      // the mast turns its cameras to the target
  kObserve,  // the rover rests and takes image pairs
  kDrive,
  kDeploy,  // the arm swings out
  kWeigh,   // rises empty
  kReturn,  // and comes down again
  kLower,
  kClose,
  kLift,
  kLifted,
  kInspect,  // one more image pair of where the stone was
  kUnfold,   // the mast moves the instrument to 20 cm before the surface
  kAdvance,  // along the normal
  kPress,    // after the first contact
  kHold,
  kRetract,
  kStow,
  kBackOff,
  kDone,
  kGivenUp,
};
inline constexpr int kPhaseCount = static_cast<int>(Phase::kGivenUp) + 1;

enum class Event {
  kNone,
  kPlanned,  // arcs to drive
  kArrived,  // the move is over
  kReached,  // arm or mast can act from here
  kWeighs,   // arrived, and the arm is to be weighed
  kTouched,
  kHeld,    // the stone is in the scoops; the instrument was on the face
  kUnsure,  // of the stone
  kMissed,  // nothing detected, gripped or touched, and there is another attempt
  kFailed,
};
inline constexpr int kEventCount = static_cast<int>(Event::kFailed) + 1;

const char* Name(Phase phase);
inline bool Approaches(Phase phase) { return phase <= Phase::kDrive; }
inline bool Grasps(Phase phase) { return phase >= Phase::kDeploy && phase <= Phase::kLift; }
inline bool Places(Phase phase) { return phase >= Phase::kUnfold && phase <= Phase::kStow; }
inline bool IsOver(Phase phase) { return phase >= Phase::kDone; }
Verdict VerdictOf(Phase phase);

/// The phase that follows; none where the event means nothing in this phase of the task.
std::optional<Phase> Next(Task task, Phase phase, Event event);
/// Goes on to it. The event must mean something there.
void Follow(Task task, Event event, Phase& phase);

}  // namespace dockyard::rocky7
