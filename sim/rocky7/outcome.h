// How a run of Rocky 7 can end, by the truth.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/io/commands.h"
#include "controller/rocky7/nominal/nominal.h"
#include "sim/log/judged_limit.h"

namespace dockyard::rocky7 {

enum class Outcome {
  kOnTarget,
  kGrasped,
  kPlaced,
  kLostGrip,
  kFalseGrasp,
  kMissedGrasp,
  kPressed,
  kMisplaced,
  kTilted,
  kFalsePlace,
  kNearTarget,
  kOffTarget,
  kWrongLock,
  kLostTarget,
  kUnstable,
  kGaveUp,
  kOnStone,
  kTimeout
};

/// In the order of Outcome.
const std::vector<OutcomeName>& OutcomeNames();
const char* Name(Outcome outcome);
/// What the task asks for.
Outcome SuccessOf(Task task);

struct OutcomeLimits {
  double reach_m = 0.01;  // "to within 1 cm" (Nesnas, Maimone and Das 2000)
  double wrong_lock_m =
      0.03;              // a claim this far off is of another thing: half a stone's width more
  double lost_m = 0.03;  // a last detection this far off is of another thing
  double tilt_rad = Radians(5.0);  // of a placement: 5 deg
  double most_n = 10.0;
  double lifted_m = 0.02;  // a stone that has risen so far is off the ground; assumed, 1-5 cm
};

/// What the truth says at the end.
struct EndOfRun {
  Verdict claimed = Verdict::kUnderWay;
  bool grasps = false;          // a grasp was asked for
  int tried = 0;                // times that the arm was sent out
  bool lifted = false;          // the target was off the ground at some time
  double rise_m = 0.0;          // of the target at the end, the least of it in a trial
  double point_off_m = 0.0;     // the point from the target's middle
  bool sighted = true;          // the target was sighted at some time
  double estimate_off_m = 0.0;  // the target as it was sighted last
  bool places = false;          // the instrument was to be placed
  bool touched = false;         // its face has met the rock
  double tilt_rad = 0.0;        // of it off the rock's normal there
  double most_n = 0.0;          // on it, in the whole run
  bool on_stone = false;        // of body, suspension or mast
};

struct Judged {
  Outcome outcome = Outcome::kTimeout;
  std::string note;
};
/// What the run is held against: a grasp by the stone's rise, another task by the point.
std::vector<JudgedLimit> LimitsOf(const EndOfRun& end, const OutcomeLimits& limits);
Judged JudgeEnd(const EndOfRun& end, const OutcomeLimits& limits);

}  // namespace dockyard::rocky7
