// Which of the seven states comes next (F, C.3; readings in raposa.md, 1.5 and 8).
#pragma once

#include <cstdint>
#include <optional>

#include "controller/raposa/marks.h"
#include "controller/raposa/nominal/ferreira_options.h"

namespace dockyard::raposa {

/// With the paper's numbers.
enum class State : std::uint8_t {
  kApproach = 1,  // region I: towards the ellipse
  kAlign,         // region II: onto the axis
  kOrangeFar,     // an ellipse far away, without blue
  kBlueOnly,      // a rectangle, without an ellipse
  kNothing,       // search
  kFinal,         // the last centimetres, by time
  kVisualTurn,    // the first part of state 2's first turn
};
const char* Name(State state);

/// What the choice needs of a frame.
struct StateCues {
  struct Pair {
    double alpha_rad = 0.0;  // signed
    double r_m = 0.0;        // camera to guide, by the blue square
  };
  std::optional<Pair> pair;
  std::optional<double> orange_m;  // camera to guide, by the ellipse's area
  bool blue = false;
};
StateCues CuesOf(const MarksSeen& seen);

/// Region I: 15 deg about the axis; the tolerance's angle within the tolerance's distances.
bool InRegionOne(double alpha_rad, double r_m, const FerreiraMotion& options);

/// A pair: 1 or 2 by angle and distance, 1 at any angle in the dead zone. No pair: by the ellipse's
/// distance 6, 1 or 3. No ellipse: 4 with a rectangle, else 5. State 1 nearer than final_m is 6.
/// "15 deg and/or 34 cm" (F, C.3) is read as "and": with "or" every start beyond 34 cm would
/// manoeuvre.
State ChooseState(const StateCues& cues, const FerreiraMotion& options);

}  // namespace dockyard::raposa
