#include "controller/raposa/phases.h"

#include <array>
#include <initializer_list>

namespace dockyard::raposa {
namespace {

using enum Phase;

constexpr unsigned Set(std::initializer_list<Phase> phases) {
  unsigned set = 0;
  for (const Phase phase : phases) set |= 1U << static_cast<int>(phase);
  return set;
}

// A try that fails or lasts too long ends in a retreat, and the last one altogether. Marks that
// come into view stop the robot in every phase with images.
constexpr unsigned kFailed = Set({kRetreat, kGivenUp});
constexpr unsigned kImages = kFailed | Set({kLook});

struct Row {
  const char* name;
  bool takes_images;
  unsigned next;
};

constexpr std::array<Row, kPhaseCount> kRows{{
    {"look", true, kImages | Set({kSearch, kCreep, kGlance, kTurn, kFace, kApproach})},
    {"search", true, kImages | Set({kTurn, kFace, kBack})},
    {"creep", true, kImages},
    {"glance", true, kImages | Set({kTurn, kFace, kBack})},
    {"back", true, kImages},
    {"turn", true, kImages | Set({kTurn, kLeg, kFace})},
    {"leg", true, kImages | Set({kTurn, kFace})},
    {"face", true, kImages},
    {"approach", true, kImages | Set({kBrake})},
    {"brake", false, kFailed | Set({kClose})},
    {"close", false, kFailed | Set({kAjar, kProve})},
    {"ajar", false, kFailed | Set({kBrake})},
    {"prove", false, kFailed | Set({kDocked})},
    {"retreat", true, kImages},
    {"docked", false, 0},
    {"given_up", false, 0},
}};

const Row& RowOf(Phase phase) { return kRows[static_cast<std::size_t>(phase)]; }

}  // namespace

const char* Name(Phase phase) { return RowOf(phase).name; }

bool TakesImages(Phase phase) { return RowOf(phase).takes_images; }

bool MayFollow(Phase phase, Phase next) { return (RowOf(phase).next & Set({next})) != 0; }

}  // namespace dockyard::raposa
