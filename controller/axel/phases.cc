#include "controller/axel/phases.h"

#include <array>

#include "controller/base/check.h"

namespace dockyard::axel {
namespace {

struct Transition {
  Phase from;
  Event event;
  Phase to;
};

constexpr std::array kTransitions = {
    Transition{Phase::kTighten, Event::kTaut, Phase::kLook},
    Transition{Phase::kLook, Event::kNotSeen, Phase::kSearch},
    Transition{Phase::kLook, Event::kTetherAbeam, Phase::kSearch},
    Transition{Phase::kLook, Event::kGoApproach, Phase::kApproach},
    Transition{Phase::kLook, Event::kGoAlign, Phase::kAlign},
    Transition{Phase::kLook, Event::kGoBackOff, Phase::kBackOff},
    Transition{Phase::kLook, Event::kGoMate, Phase::kMate},
    Transition{Phase::kLook, Event::kGoRecover, Phase::kRecover},
    Transition{Phase::kLook, Event::kInside, Phase::kReel},
    Transition{Phase::kLook, Event::kGoBlind, Phase::kHaul},
    Transition{Phase::kSearch, Event::kGoBlind, Phase::kHaul},
    Transition{Phase::kHaul, Event::kArrived, Phase::kReel},
    Transition{Phase::kSearch, Event::kArrived, Phase::kTighten},
    Transition{Phase::kSearch, Event::kGoRecover, Phase::kRecover},
    Transition{Phase::kApproach, Event::kArrived, Phase::kTighten},
    Transition{Phase::kAlign, Event::kArrived, Phase::kTighten},
    Transition{Phase::kApproach, Event::kGoApproach, Phase::kApproach},
    Transition{Phase::kApproach, Event::kGoAlign, Phase::kAlign},
    Transition{Phase::kAlign, Event::kGoApproach, Phase::kApproach},
    Transition{Phase::kAlign, Event::kGoAlign, Phase::kAlign},
    Transition{Phase::kBackOff, Event::kArrived, Phase::kTighten},
    Transition{Phase::kRecover, Event::kArrived, Phase::kTighten},
    Transition{Phase::kBackOff, Event::kDigs, Phase::kOut},
    Transition{Phase::kRecover, Event::kDigs, Phase::kOut},
    Transition{Phase::kOut, Event::kArrived, Phase::kTighten},
    Transition{Phase::kMate, Event::kArrived, Phase::kRecheck},
    Transition{Phase::kRecheck, Event::kGoMate, Phase::kEnter},
    Transition{Phase::kRecheck, Event::kGoRecover, Phase::kRecover},
    Transition{Phase::kEnter, Event::kArrived, Phase::kReel},
    Transition{Phase::kReel, Event::kReeledIn, Phase::kConfirm},
    Transition{Phase::kConfirm, Event::kSteady, Phase::kDocked},
    Transition{Phase::kConfirm, Event::kStopsShort, Phase::kReel},
    Transition{Phase::kConfirm, Event::kStuck, Phase::kRecover},
    Transition{Phase::kUndock, Event::kArrived, Phase::kExcursion},
    Transition{Phase::kExcursion, Event::kArrived, Phase::kReturn},
    Transition{Phase::kReturn, Event::kArrived, Phase::kTighten},
    Transition{Phase::kRight, Event::kArrived, Phase::kTighten},
};

}  // namespace

const char* Name(Phase phase) {
  static constexpr std::array<const char*, kPhaseCount> kNames = {
      "tighten", "look",      "search",  "approach", "align",  "back_off", "out",
      "recover", "mate",      "recheck", "enter",    "reel",   "confirm",  "haul",
      "undock",  "excursion", "return",  "right",    "docked", "given_up"};
  return kNames[static_cast<std::size_t>(phase)];
}

std::optional<Phase> Next(Phase phase, Event event) {
  const bool over = phase == Phase::kDocked || phase == Phase::kGivenUp;
  if (event == Event::kLimitReached && !over) return Phase::kGivenUp;
  if (event == Event::kTurnedOver && !over) return Phase::kRight;
  for (const Transition& row : kTransitions) {
    if (row.from == phase && row.event == event) return row.to;
  }
  return std::nullopt;
}

}  // namespace dockyard::axel
