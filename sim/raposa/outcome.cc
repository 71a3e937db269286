#include "sim/raposa/outcome.h"

#include <algorithm>
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

std::string OutcomeJudge::ClaimNote() const {
  std::string note = GuidePlace(last_);
  if (last_.p_SP_R.norm() >= limits_.seated_within_m) {
    note += Sentence(" (docked: within %.0f mm)", 1e3 * limits_.seated_within_m);
  }
  const double open_m = std::max(last_.left_door_m, last_.right_door_m);
  if (open_m >= limits_.closed_m) {
    note += Sentence(", a door %.0f mm from closed (less than %.0f mm)", 1e3 * open_m,
                     1e3 * limits_.closed_m);
  }
  return note;
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
    if (!trial.done) return {Outcome::kFalseDocked, "claimed docked; " + ClaimNote()};
    return {Outcome::kFalseDocked,
            Sentence("claimed docked; driven away, the guide came %.0f mm off its seat (at most "
                     "%.0f mm)",
                     1e3 * trial.worst_m, 1e3 * limits_.seated_within_m)};
  }
  if (tipped_since_s_) {
    return {Outcome::kTippedPyramid,
            Sentence("the pyramid leans by %.0f deg (at most %.0f deg)",
                     Degrees(last_.pyramid_tilt_rad), Degrees(limits_.tipped_rad))};
  }
  if (stay_ && last_.time_s - stay_->since_s > limits_.jam_time_s) {
    return {Outcome::kJammed, GuidePlace(last_)};
  }
  if (last_.pyramid_shift_m > limits_.pushed_m) {
    return {Outcome::kPushedAway,
            Sentence("the pyramid was pushed by %.0f mm (at most %.0f mm) and turned by %.0f deg",
                     1e3 * last_.pyramid_shift_m, 1e3 * limits_.pushed_m,
                     Degrees(last_.pyramid_turn_rad))};
  }
  if (touched_since_s_) return {Outcome::kMissedSocket, GuidePlace(last_)};
  const std::string where = Sentence("the camera %.2f m from the guide, %.0f deg off its axis",
                                     last_.range_m, Degrees(last_.alpha_rad));
  if (claimed != Verdict::kGivenUp) return {Outcome::kTimeout, where};
  return {searches ? Outcome::kSearchLimit : Outcome::kGaveUp, where};
}

}  // namespace dockyard::raposa
