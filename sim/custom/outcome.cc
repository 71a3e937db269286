#include "sim/custom/outcome.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"

namespace dockyard::custom {
namespace {

bool Within(double value, double most) { return std::isnan(most) || std::abs(value) <= most; }

// NaN where there is no limit.
double Judge(double value, double limit) { return std::isnan(limit) ? limit : std::abs(value); }

JudgedLimit AtMost(const char* name, const char* unit, const char* meaning, double value,
                   double limit) {
  return {name, unit, meaning, LimitSense::kAtMost, Judge(value, limit), limit};
}

std::string StateNote(const EndOfRun& end, const JudgeKeys& keys) {
  const Truth& t = end.truth;
  std::string note = "robot " + Fixed(1e3 * t.X_QP.p.x(), 1) + " mm along and " +
                     Fixed(1e3 * t.X_QP.p.y(), 1) + " mm across its place, turned by " +
                     Fixed(Degrees(ToRollPitchYaw(t.X_QP.R).yaw), 1) + " deg";
  if (end.contact_asked) {
    note += std::string(", contact ") + (end.contact.closed ? "closed" : "open") + " with " +
            Fixed(end.contact.force_n, 1) + " N";
  }
  const std::string broken = BrokenLimitsText(LimitsOf(end, keys));
  return broken.empty() ? note : note + "; " + broken;
}

/// " in 'search': no dock detected".
std::string PhaseText(const EndOfRun& end) {
  if (end.phase.empty()) return "";
  return " in '" + end.phase + "'" + (end.said.empty() ? "" : ": " + end.said);
}

Judged JudgeClaim(const EndOfRun& end, const JudgeKeys& keys, const std::string& note) {
  const Condition& docked = keys.docked;
  if (end.held && (!end.tried || end.kept)) return {Outcome::kDocked, note};
  if (end.held)
    return {
        Outcome::kContactLost,
        "did not last the trial" + (end.lost_in.empty() ? "" : "'s " + end.lost_in) + "; " + note};
  if (end.contact_asked && end.was_closed && !end.contact.closed) {
    return {Outcome::kContactLost, "claims to be docked; " + note};
  }
  const bool seated = Holds(docked.pose, end.truth.X_QP);
  const bool closed = end.contact_asked && end.contact.closed;
  if (seated || closed) return {Outcome::kPartlySeated, "claims to be docked; " + note};
  return {Outcome::kFalseDocked, "claims to be docked; " + note};
}

}  // namespace

const std::vector<OutcomeName>& OutcomeNames() {
  static const std::vector<OutcomeName> names{
      {"docked", true, "claims to be docked, all conditions hold for the time, and in the trial"},
      {"partly_seated", false,
       "claims to be docked; the pose holds without the contact, or the contact without the pose"},
      {"contact_lost", false, "the contact was closed, and is not after the hold or the trial"},
      {"collided", false, "robot and dock pressed on each other by more than a collision's force"},
      {"dock_pushed", false, "the dock was moved or turned by more than is allowed"},
      {"tipped_over", false, "the robot or the dock has tipped over"},
      {"false_docked", false, "claims to be docked, and neither pose nor contact holds"},
      {"gave_up", false, "the controller gave up"},
      {"timeout", false, "ran out of time, and nothing else explains it"}};
  return names;
}

const char* Name(Outcome outcome) {
  return OutcomeNames()[static_cast<std::size_t>(outcome)].name.c_str();
}

const ContactTruth* Find(const Truth& truth, const std::vector<std::string>& names,
                         const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? nullptr
                           : &truth.contacts[static_cast<std::size_t>(at - names.begin())];
}

bool Holds(const PoseBox& box, const Pose3& X_QP) {
  const RollPitchYaw turn = ToRollPitchYaw(X_QP.R);
  return Within(X_QP.p.x(), box.x_m) && Within(X_QP.p.y(), box.y_m) &&
         Within(X_QP.p.z(), box.z_m) && Within(turn.roll, box.roll_rad) &&
         Within(turn.pitch, box.pitch_rad) && Within(turn.yaw, box.yaw_rad);
}

bool Holds(const ContactAsked& asked, const ContactTruth* contact) {
  if (contact == nullptr) return true;
  return contact->closed == asked.closed &&
         (std::isnan(asked.least_n) || contact->force_n >= asked.least_n);
}

std::vector<JudgedLimit> LimitsOf(const EndOfRun& end, const JudgeKeys& keys) {
  const PoseBox& box = keys.docked.pose;
  const Truth& t = end.truth;
  const RollPitchYaw turn = ToRollPitchYaw(t.X_QP.R);
  std::vector<JudgedLimit> limits{
      AtMost("off_x_m", "m", "the robot's frame in the dock's, along x", t.X_QP.p.x(), box.x_m),
      AtMost("off_y_m", "m", "the same along y", t.X_QP.p.y(), box.y_m),
      AtMost("off_z_m", "m", "the same along z", t.X_QP.p.z(), box.z_m),
      AtMost("off_roll_deg", "deg", "the same turned about x", Degrees(turn.roll),
             Degrees(box.roll_rad)),
      AtMost("off_pitch_deg", "deg", "the same about y", Degrees(turn.pitch),
             Degrees(box.pitch_rad)),
      AtMost("off_yaw_deg", "deg", "the same about z", Degrees(turn.yaw), Degrees(box.yaw_rad)),
      AtMost("touch_n", "N", "between robot and dock", t.touch_n, keys.docked.most_n),
      AtMost("collision_n", "N", "most of it in the run", t.peak_touch_n, keys.collided_n),
      AtMost("dock_moved_m", "m", "the dock from where it was", t.dock_moved_m, keys.pushed_m),
      AtMost("dock_turned_deg", "deg", "the same turned", Degrees(t.dock_turned_rad),
             Degrees(keys.pushed_rad))};
  limits.push_back({"contact_n", "N", "of the contact's pins, summed", LimitSense::kAtLeast,
                    std::isnan(keys.docked.contact.least_n) ? kNotAsked : end.contact.force_n,
                    keys.docked.contact.least_n});
  return limits;
}

Judged JudgeEnd(const EndOfRun& end, const JudgeKeys& keys) {
  const Truth& t = end.truth;
  const std::string note = StateNote(end, keys);
  if (std::max(t.tilt_rad, t.dock_tilt_rad) > keys.tipped_rad) {
    const bool robot = t.tilt_rad > keys.tipped_rad;
    return {Outcome::kTippedOver, std::string("the ") + (robot ? "robot" : "dock") + " by " +
                                      Fixed(Degrees(robot ? t.tilt_rad : t.dock_tilt_rad), 1) +
                                      " deg; " + note};
  }
  if (t.peak_touch_n > keys.collided_n) return {Outcome::kCollided, note};
  if (t.dock_moved_m > keys.pushed_m || t.dock_turned_rad > keys.pushed_rad) {
    return {Outcome::kDockPushed, note};
  }
  if (end.claimed == Verdict::kDone) return JudgeClaim(end, keys, note);
  if (end.contact_asked && end.was_closed && !end.contact.closed) {
    return {Outcome::kContactLost, note};
  }
  if (end.claimed == Verdict::kGivenUp)
    return {Outcome::kGaveUp, "gave up" + (end.said.empty() ? "" : ": " + end.said) + "; " + note};
  return {Outcome::kTimeout, "ran out of time" + PhaseText(end) + "; " + note};
}

}  // namespace dockyard::custom
