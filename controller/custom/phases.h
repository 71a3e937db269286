// The phases of a docking and which may follow which. Where Nav2's docking server has the state,
// the name is its name.
#pragma once

namespace dockyard::custom {

enum class Phase {
  kPerceive,   // at rest, until sightings give the dock's pose
  kSearch,     // turns in place to detect the dock
  kTurnTo,     // turns to the staging pose, or its back to it; or to where it detected the dock
  kStaging,    // drives there
  kFace,       // turns there to where a camera measures the dock
  kTurnRound,  // turns to the docked heading, if no camera sees the dock in it
  kControl,    // along the control law to the docked pose
  kPress,      // straight on until the contact closes
  kWait,       // at rest, until the contact has been closed for a while
  kWiggle,     // presses and turns to either side
  kBackOff,    // straight out for the next try
  kDocked,
  kGivenUp,
};
inline constexpr int kPhaseCount = static_cast<int>(Phase::kGivenUp) + 1;

const char* Name(Phase phase);
/// Whether sightings are of use: not while wheels slip, as the pose at the exposure is not known.
bool TakesImages(Phase phase);
/// A phase that lasts longer has failed [s].
double Most_s(Phase phase);
bool MayFollow(Phase phase, Phase next);

}  // namespace dockyard::custom
