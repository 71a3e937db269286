#include "controller/custom/phases.h"

#include <array>
#include <initializer_list>

namespace dockyard::custom {
namespace {

using enum Phase;

constexpr unsigned Set(std::initializer_list<Phase> phases) {
  unsigned set = 0;
  for (const Phase phase : phases) set |= 1U << static_cast<int>(phase);
  return set;
}

// A failed try is followed by the next one, the last by giving up: out of the dock by backing off.
constexpr unsigned kFailed = Set({kPerceive, kGivenUp});
constexpr unsigned kFailedIn = kFailed | Set({kBackOff});

struct Row {
  const char* name;
  bool takes_images;
  double most_s;  // assumed, half to twice; phases with a time of the user's have no other
  unsigned next;
};

constexpr double kOwn_s = 1e9;

constexpr std::array<Row, kPhaseCount> kRows{{
    {"initial_perception", true, kOwn_s,
     kFailed | Set({kSearch, kTurnTo, kTurnRound, kControl, kWait})},
    {"search", true, 120.0, kFailed | Set({kTurnTo})},
    {"turn_to_staging", true, 30.0, kFailed | Set({kStaging, kFace})},
    {"staging", true, 90.0, kFailed | Set({kTurnTo, kFace})},
    {"face_dock", true, 30.0, kFailed},
    {"turn_round", true, 30.0, kFailed | Set({kControl})},
    {"controlling", true, kOwn_s, kFailedIn | Set({kPress, kWait})},
    {"press", false, 30.0, kFailedIn | Set({kWait})},
    {"wait_for_charge", true, kOwn_s, kFailedIn | Set({kWiggle, kDocked})},
    {"wiggle", false, 30.0, kFailedIn | Set({kWait})},
    {"back_off", true, 60.0, kFailed | Set({kFace})},
    {"docked", false, kOwn_s, 0},
    {"given_up", false, kOwn_s, 0},
}};

const Row& RowOf(Phase phase) { return kRows[static_cast<std::size_t>(phase)]; }

}  // namespace

const char* Name(Phase phase) { return RowOf(phase).name; }

bool TakesImages(Phase phase) { return RowOf(phase).takes_images; }

double Most_s(Phase phase) { return RowOf(phase).most_s; }

bool MayFollow(Phase phase, Phase next) { return (RowOf(phase).next & Set({next})) != 0; }

}  // namespace dockyard::custom
