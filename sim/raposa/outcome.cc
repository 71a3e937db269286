#include "sim/raposa/outcome.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace dockyard::raposa {
namespace {

std::string Sentence(const char* format, ...) {
  char text[200];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return text;
}

std::string GuidePlace(const Truth& truth) {
  return Sentence("guide %.0f mm outside of its seat, %.0f mm aside and %.0f mm above it",
                  -1e3 * truth.p_SP_R.x(), 1e3 * truth.p_SP_R.y(), 1e3 * truth.p_SP_R.z());
}

}  // namespace

const std::vector<OutcomeName>& OutcomeNames() {
  static const std::vector<OutcomeName> names{
      {"docked", true,
       "doors closed behind the guide, which follows on its seat as the robot drives away and "
       "turns"},
      {"false_docked", false, "claims to be docked, and the truth says that it is not"},
      {"tipped_pyramid", false, "the pyramid lies on its side"},
      {"pushed_away", false, "the pyramid was pushed from its place, and the guide is not held"},
      {"jammed", false, "the guide stuck in the socket before its seat"},
      {"missed_socket", false, "robot and pyramid touched, the guide is not in the socket"},
      {"search_limit", false, "gave up its search"},
      {"gave_up", false, "gave up, and it is not known to search"},
      {"timeout", false, "ran out of time, and nothing else explains it"}};
  return names;
}

const char* Name(Outcome outcome) {
  return OutcomeNames()[static_cast<std::size_t>(outcome)].name.c_str();
}

void OutcomeJudge::Observe(const Truth& truth) {
  last_ = truth;
  if (truth.pyramid_tilt_rad <= limits_.tipped_rad) {
    tipped_since_s_.reset();
  } else if (!tipped_since_s_) {
    tipped_since_s_ = truth.time_s;
  }
  if (truth.contact_n > 0.0 && !touched_since_s_) touched_since_s_ = truth.time_s;
  const bool in_funnel = truth.p_SP_R.norm() < limits_.in_funnel_m;
  if (!in_funnel) {
    stay_.reset();
  } else if (!stay_ || (truth.p_SP_R - stay_->p).norm() > limits_.jam_travel_m) {
    stay_ = Stay{truth.p_SP_R, truth.time_s};
  }
}

bool OutcomeJudge::holds() const {
  return last_.p_SP_R.norm() < limits_.seated_within_m &&
         std::max(last_.left_door_m, last_.right_door_m) < limits_.closed_m;
}

std::vector<JudgedLimit> OutcomeJudge::Limits(Verdict claimed, const Trial& trial) const {
  constexpr LimitSense kAtMost = LimitSense::kAtMost;
  const bool claims = claimed == Verdict::kDone;
  const auto if_judged = [](bool judged, double value) { return judged ? value : std::nan(""); };
  return {
      {"seat_m", "m", "guide's middle from its seat, before the trial", kAtMost,
       last_.p_SP_R.norm(), limits_.seated_within_m},
      {"door_m", "m", "the door that is further from closed", kAtMost,
       std::max(last_.left_door_m, last_.right_door_m), limits_.closed_m},
      {"trial_seat_m", "m", "largest distance of the guide from its seat while driven away",
       kAtMost, if_judged(trial.done, trial.worst_m), limits_.seated_within_m},
      {"pyramid_tilt_deg", "deg", "the pyramid from upright, without a claim", kAtMost,
       if_judged(!claims, Degrees(last_.pyramid_tilt_rad)), Degrees(limits_.tipped_rad)},
      {"pyramid_shift_m", "m", "the guide from where it was at the start, without a claim", kAtMost,
       if_judged(!claims, last_.pyramid_shift_m), limits_.pushed_m},
      {"jam_s", "s", "time that the guide has stuck in the socket, without a claim", kAtMost,
       if_judged(!claims, stay_ ? last_.time_s - stay_->since_s : 0.0), limits_.jam_time_s},
  };
}

OutcomeJudge::Verdicted OutcomeJudge::Conclude(Verdict claimed, const Trial& trial,
                                               bool searches) const {
  if (claimed == Verdict::kDone) {
    const bool held = trial.done && trial.worst_m < limits_.seated_within_m;
    if (held) {
      return {Outcome::kDocked,
              Sentence("guide within %.1f mm of its seat while it was driven away",
                       1e3 * trial.worst_m)};
    }
    return {Outcome::kFalseDocked, "claimed docked; " + BrokenLimitsText(Limits(claimed, trial)) +
                                       "; " + GuidePlace(last_)};
  }
  if (tipped_since_s_) {
    return {Outcome::kTippedPyramid, BrokenLimitsText(Limits(claimed, trial))};
  }
  if (stay_ && last_.time_s - stay_->since_s > limits_.jam_time_s) {
    return {Outcome::kJammed, GuidePlace(last_)};
  }
  if (last_.pyramid_shift_m > limits_.pushed_m) {
    return {Outcome::kPushedAway,
            BrokenLimitsText(Limits(claimed, trial)) +
                Sentence(", turned by %.0f deg", Degrees(last_.pyramid_turn_rad))};
  }
  if (touched_since_s_) return {Outcome::kMissedSocket, GuidePlace(last_)};
  const std::string where = Sentence("the camera %.2f m from the guide, %.0f deg off its axis",
                                     last_.range_m, Degrees(last_.alpha_rad));
  if (claimed != Verdict::kGivenUp) return {Outcome::kTimeout, where};
  return {searches ? Outcome::kSearchLimit : Outcome::kGaveUp, where};
}

}  // namespace dockyard::raposa
