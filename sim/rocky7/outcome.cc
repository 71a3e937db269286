#include "sim/rocky7/outcome.h"

#include <cmath>

#include "controller/base/number_text.h"
#include "controller/geometry/pose.h"

namespace dockyard::rocky7 {
namespace {

std::string Millimetres(double length_m) { return Fixed(1e3 * length_m, 0) + " mm"; }

Judged JudgePlacement(const EndOfRun& end, const OutcomeLimits& limits) {
  const std::string broken = BrokenLimitsText(LimitsOf(end, limits));
  const std::string note = "touched " + Millimetres(end.point_off_m) + " off the target, " +
                           Fixed(Degrees(end.tilt_rad), 1) + " deg off its normal, by " +
                           Fixed(end.most_n, 1) + " N" + (broken.empty() ? "" : "; ") + broken;
  if (end.most_n > limits.most_n) return {Outcome::kPressed, note};
  if (end.point_off_m > limits.reach_m) return {Outcome::kMisplaced, note};
  if (end.tilt_rad > limits.tilt_rad) return {Outcome::kTilted, note};
  if (end.claimed == Verdict::kDone) return {Outcome::kPlaced, note};
  return {end.claimed == Verdict::kGivenUp ? Outcome::kUnstable : Outcome::kTimeout,
          (end.claimed == Verdict::kGivenUp ? "gave up; " : "ran out of time; ") + note};
}

}  // namespace

const std::vector<OutcomeName>& OutcomeNames() {
  static const std::vector<OutcomeName> names{
      {"on_target", true, "the point is on the target's middle, as near as was asked"},
      {"grasped", true, "the stone is in the scoops, for 10 s and over half a metre of driving"},
      {"placed", true,
       "the instrument stood on the point that was clicked on, within 2 cm and 5 deg, by less than "
       "10 N"},
      {"lost_grip", false, "the stone was lifted and lost; the paper's marginal ones"},
      {"false_grasp", false, "as missed_grasp, and claims to hold the stone"},
      {"missed_grasp", false, "the scoops closed on nothing, the point within 1 cm of the stone"},
      {"pressed", false, "the instrument was pressed on the rock by more than is allowed"},
      {"misplaced", false,
       "the instrument touched the rock, further from the target than is allowed"},
      {"tilted", false, "it touched it there, further off the surface's normal than is allowed"},
      {"false_place", false, "claims a contact that there was not"},
      {"near_target", false, "to bring the point there: within 3 cm, but not as near as was asked"},
      {"off_target", false,
       "the scoops closed on nothing, the point further than 1 cm from the stone"},
      {"wrong_lock", false, "took itself to be there, and the point is on another thing"},
      {"lost_target", false, "gave up, and had the target last where it is not"},
      {"unstable", false, "gave up though it saw the target: its steps are coarser than its reach"},
      {"gave_up", false, "gave up without a sighting of the target"},
      {"on_stone", false, "body, suspension or mast met a stone or the boulder"},
      {"timeout", false, "ran out of time, and nothing else explains it"}};
  return names;
}

const char* Name(Outcome outcome) {
  return OutcomeNames()[static_cast<std::size_t>(outcome)].name.c_str();
}

Outcome SuccessOf(Task task) {
  return task == Task::kGrasp   ? Outcome::kGrasped
         : task == Task::kPlace ? Outcome::kPlaced
                                : Outcome::kOnTarget;
}

std::vector<JudgedLimit> LimitsOf(const EndOfRun& end, const OutcomeLimits& limits) {
  const auto if_judged = [](bool judged, double value) { return judged ? value : std::nan(""); };
  const bool contact = end.places && end.touched, grasp = !end.places && end.tried > 0;
  return {
      {"point_off_m", "m", "the point off the target, at the end; of a placement, at its contact",
       LimitSense::kAtMost, if_judged(end.places ? contact : !grasp, end.point_off_m),
       limits.reach_m},
      {"tilt_deg", "deg", "the instrument off the rock's normal, at its contact",
       LimitSense::kAtMost, if_judged(contact, Degrees(end.tilt_rad)), Degrees(limits.tilt_rad)},
      {"face_force_n", "N", "largest force on the instrument's face", LimitSense::kAtMost,
       if_judged(contact, end.most_n), limits.most_n},
      {"rise_m", "m", "of a stone after a grasp, the least of it in the trial",
       LimitSense::kAtLeast, if_judged(grasp, end.rise_m), limits.lifted_m}};
}

Judged JudgeEnd(const EndOfRun& end, const OutcomeLimits& limits) {
  const std::string point = "the point " + Millimetres(end.point_off_m) + " off the target";
  const std::string sighted =
      end.sighted ? "the target was sighted " + Millimetres(end.estimate_off_m) + " off"
                  : "the target was not sighted";
  if (end.on_stone)
    return {Outcome::kOnStone, "body, suspension or mast met a stone or the boulder; " + point};
  if (end.places && end.touched) return JudgePlacement(end, limits);
  if (end.places && end.claimed == Verdict::kDone) {
    return {Outcome::kFalsePlace, "claimed a contact; the instrument touched nothing"};
  }
  if (end.tried > 0) {
    if (end.lifted && end.claimed == Verdict::kDone && end.rise_m >= limits.lifted_m) {
      return {Outcome::kGrasped, "held through the trial"};
    }
    if (end.lifted) return {Outcome::kLostGrip, "the stone was lifted and lost; " + point};
    if (end.claimed != Verdict::kUnderWay) {
      const Outcome near =
          end.claimed == Verdict::kDone ? Outcome::kFalseGrasp : Outcome::kMissedGrasp;
      return {end.point_off_m > limits.wrong_lock_m ? Outcome::kWrongLock
              : end.point_off_m > limits.reach_m    ? Outcome::kOffTarget
                                                    : near,
              "the scoops closed on nothing; " + point};
    }
  }
  switch (end.claimed) {
    case Verdict::kDone:
      if (end.point_off_m <= limits.reach_m) return {Outcome::kOnTarget, point};
      return {end.point_off_m > limits.wrong_lock_m ? Outcome::kWrongLock : Outcome::kNearTarget,
              "claimed to be there; " + BrokenLimitsText(LimitsOf(end, limits))};
    case Verdict::kGivenUp:
      if (!end.sighted) return {Outcome::kGaveUp, "gave up; " + sighted + ", " + point};
      return {end.estimate_off_m > limits.lost_m ? Outcome::kLostTarget : Outcome::kUnstable,
              "gave up; " + sighted};
    case Verdict::kUnderWay:
      break;
  }
  return {Outcome::kTimeout, point + "; " + sighted};
}

}  // namespace dockyard::rocky7
