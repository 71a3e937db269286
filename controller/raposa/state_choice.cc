#include "controller/raposa/state_choice.h"

#include <cmath>

namespace dockyard::raposa {

const char* Name(State state) {
  switch (state) {
    case State::kApproach:
      return "approach";
    case State::kAlign:
      return "align";
    case State::kOrangeFar:
      return "orange_far";
    case State::kBlueOnly:
      return "blue_only";
    case State::kNothing:
      return "search";
    case State::kFinal:
      return "final";
    case State::kVisualTurn:
      break;
  }
  return "visual_turn";
}

StateCues CuesOf(const MarksSeen& seen) {
  StateCues cues;
  if (seen.pair) cues.pair = {seen.pair->alpha_rad, seen.pair->angle.r_m};
  if (seen.orange) cues.orange_m = seen.orange->distance_m;
  cues.blue = seen.blue.has_value();
  return cues;
}

bool InRegionOne(double alpha_rad, double r_m, const FerreiraMotion& options) {
  const bool tolerant = r_m >= options.tolerance_from_m && r_m <= options.tolerance_to_m;
  return std::abs(alpha_rad) <= (tolerant ? options.tolerance_rad : options.region_one_rad);
}

State ChooseState(const StateCues& cues, const FerreiraMotion& options) {
  if (cues.pair) {
    const bool near = cues.pair->r_m < options.dead_zone_m;
    if (!near && !InRegionOne(cues.pair->alpha_rad, cues.pair->r_m, options)) return State::kAlign;
  }
  if (cues.orange_m) {
    if (*cues.orange_m < options.final_m) return State::kFinal;
    const bool far = !cues.pair && *cues.orange_m > options.orange_far_m;
    return far ? State::kOrangeFar : State::kApproach;
  }
  return cues.blue ? State::kBlueOnly : State::kNothing;
}

}  // namespace dockyard::raposa
