// The phases of RAPOSA's docking and which may follow which.
#pragma once

namespace dockyard::raposa {

enum class Phase {
  kLook,      // stands and takes images
  kSearch,    // turns to find the guide
  kCreep,     // towards a guide that is too far for a sure pose
  kGlance,    // turns a little to either side of a guide whose square may be out
              // of view
  kBack,      // straight back, away from a guide that is too near for its marks
  kTurn,      // in place, to a leg's heading
  kLeg,       // straight on a leg to the gate
  kFace,      // turns to the pyramid
  kApproach,  // along the axis onto the seat
  kBrake,     // stands before the doors close
  kClose,
  kAjar,   // opens the doors a little and drives on by a nudge
  kProve,  // pulls at the guide
  kRetreat,
  kDocked,
  kGivenUp,
};
inline constexpr int kPhaseCount = static_cast<int>(Phase::kGivenUp) + 1;

const char* Name(Phase phase);
/// Whether images are of use: not with the robot on its seat.
bool TakesImages(Phase phase);
bool MayFollow(Phase phase, Phase next);

}  // namespace dockyard::raposa
