#include "controller/rocky7/phases.h"

#include <array>
#include <span>

#include "controller/base/check.h"

namespace dockyard::rocky7 {
namespace {

struct Transition {
  Phase from;
  Event event;
  Phase to;
};

constexpr Transition kReach[] = {{Phase::kObserve, Event::kPlanned, Phase::kDrive},
                                 {Phase::kDrive, Event::kArrived, Phase::kObserve},
                                 {Phase::kObserve, Event::kReached, Phase::kDone}};

constexpr Transition kGrasp[] = {{Phase::kObserve, Event::kPlanned, Phase::kDrive},
                                 {Phase::kDrive, Event::kArrived, Phase::kObserve},
                                 {Phase::kObserve, Event::kReached, Phase::kDeploy},
                                 {Phase::kDeploy, Event::kWeighs, Phase::kWeigh},
                                 {Phase::kDeploy, Event::kArrived, Phase::kLower},
                                 {Phase::kWeigh, Event::kArrived, Phase::kReturn},
                                 {Phase::kReturn, Event::kArrived, Phase::kLower},
                                 {Phase::kLower, Event::kTouched, Phase::kClose},
                                 {Phase::kClose, Event::kArrived, Phase::kLift},
                                 {Phase::kLift, Event::kArrived, Phase::kLifted},
                                 {Phase::kLift, Event::kMissed, Phase::kObserve},
                                 {Phase::kLifted, Event::kHeld, Phase::kDone},
                                 {Phase::kLifted, Event::kUnsure, Phase::kInspect},
                                 {Phase::kInspect, Event::kHeld, Phase::kDone},
                                 {Phase::kInspect, Event::kMissed, Phase::kObserve}};

constexpr Transition kPlace[] = {{Phase::kAim, Event::kArrived, Phase::kObserve},
                                 {Phase::kObserve, Event::kMissed, Phase::kAim},
                                 {Phase::kObserve, Event::kPlanned, Phase::kDrive},
                                 {Phase::kDrive, Event::kArrived, Phase::kAim},
                                 {Phase::kDrive, Event::kReached, Phase::kUnfold},
                                 {Phase::kObserve, Event::kReached, Phase::kUnfold},
                                 {Phase::kUnfold, Event::kArrived, Phase::kAdvance},
                                 {Phase::kAdvance, Event::kTouched, Phase::kPress},
                                 {Phase::kAdvance, Event::kMissed, Phase::kRetract},
                                 {Phase::kPress, Event::kArrived, Phase::kHold},
                                 {Phase::kHold, Event::kArrived, Phase::kRetract},
                                 {Phase::kRetract, Event::kArrived, Phase::kStow},
                                 {Phase::kStow, Event::kHeld, Phase::kBackOff},
                                 {Phase::kStow, Event::kMissed, Phase::kAim},
                                 {Phase::kBackOff, Event::kArrived, Phase::kDone}};

std::span<const Transition> TableOf(Task task) {
  switch (task) {
    case Task::kReach:
      return kReach;
    case Task::kGrasp:
      return kGrasp;
    case Task::kPlace:
      break;
  }
  return kPlace;
}

}  // namespace

const char* Name(Phase phase) {
  static constexpr std::array<const char*, kPhaseCount> kNames = {
      "aim",   "look",    "drive", "deploy",   "weigh",  "weigh",   "lower",
      "close", "lift",    "ended", "peek",     "unfold", "advance", "press",
      "hold",  "retract", "stow",  "back_off", "done",   "given_up"};
  return kNames[static_cast<std::size_t>(phase)];
}

Verdict VerdictOf(Phase phase) {
  return phase == Phase::kDone      ? Verdict::kDone
         : phase == Phase::kGivenUp ? Verdict::kGivenUp
                                    : Verdict::kUnderWay;
}

std::optional<Phase> Next(Task task, Phase phase, Event event) {
  if (event == Event::kNone) return phase;
  if (event == Event::kFailed && !IsOver(phase)) return Phase::kGivenUp;
  for (const Transition& row : TableOf(task)) {
    if (row.from == phase && row.event == event) return row.to;
  }
  return std::nullopt;
}

void Follow(Task task, Event event, Phase& phase) {
  const auto next = Next(task, phase, event);
  DOCKYARD_CHECK(next.has_value());
  phase = *next;
}

}  // namespace dockyard::rocky7
