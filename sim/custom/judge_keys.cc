#include "sim/custom/judge_keys.h"

#include "controller/geometry/pose.h"

namespace dockyard::custom {
namespace {

using enum Presence;

void VisitPose(Keys& keys, PoseBox& pose, bool named) {
  if (named) {
    keys.Text({"robot", "", "a link of the robot", kRequired}, pose.robot);
    keys.Text({"dock", "", "a link of the dock, on which it lies when docked", kRequired},
              pose.dock);
  }
  keys.Number({"x_m", "m", "most that it may be off along the dock's link", kUnset}, pose.x_m,
              Positive(10.0));
  keys.Number({"y_m", "m", "the same across", kUnset}, pose.y_m, Positive(10.0));
  keys.Number({"z_m", "m", "the same up", kUnset}, pose.z_m, Positive(10.0));
  keys.Degrees({"roll_deg", "deg", "most that it may be turned about x", kUnset}, pose.roll_rad,
               Positive(180.0));
  keys.Degrees({"pitch_deg", "deg", "the same about y", kUnset}, pose.pitch_rad, Positive(180.0));
  keys.Degrees({"yaw_deg", "deg", "the same about z", kUnset}, pose.yaw_rad, Positive(180.0));
}

void VisitContact(Keys& keys, ContactAsked& contact) {
  keys.Text({"pins", "", "name of the electrical contact", kRequired}, contact.pins);
  keys.Bool({"closed", "", "all its poles conduct"}, contact.closed);
  keys.Number({"least_n", "N", "least sum of its pins' forces", kUnset}, contact.least_n,
              Positive(1e4));
}

void VisitDocked(Keys& keys, JudgeKeys& judge) {
  Condition& docked = judge.docked;
  keys.Number({"hold_s", "s", "all conditions hold for so long"}, judge.hold_s, Between(0.0, 60.0));
  keys.Mapping({"pose", "", "", kRequired}, [&](Keys& in) { VisitPose(in, docked.pose, true); });
  keys.Mapping(Unset("contact"), [&](Keys& in) { VisitContact(in, docked.contact); });
  keys.Mapping(Unset("force"), [&](Keys& in) {
    std::vector<std::string> between{"robot", "dock"};
    in.Texts({"between", "", "robot and dock"}, between, 2);
    in.Number({"most_n", "N", "most sum of their forces", kRequired}, docked.most_n, Positive(1e5));
  });
  keys.Mapping(Unset("speed"), [&](Keys& in) {
    in.Number({"most_m_s", "m/s", "of the robot", kRequired}, docked.most_m_s, Positive(10.0));
  });
}

void VisitTrial(Keys& keys, TrialKeys& trial) {
  keys.Number({"push_n", "N", "level force of each push on the robot's root; 0: no push"},
              trial.push_n, NonNegative(1e4));
  std::size_t count = trial.towards_rad.size();
  keys.List(
      {"pushes", "",
       "directions of pushes, one after the other; by default one away from the dock"},
      0, 8, count, [&](std::size_t n) { trial.towards_rad.assign(n, 0.0); },
      [&](Keys& in, std::size_t i) {
        in.Degrees({"towards_deg", "deg", "from x of the dock's root link", kRequired},
                   trial.towards_rad[i], Between(-180.0, 180.0));
      });
  keys.Number({"for_s", "s", "of each push, shake and drive"}, trial.for_s, Positive(60.0));
  keys.Number({"shake_n", "N", "force to and fro across the dock"}, trial.shake_n,
              NonNegative(1e4));
  keys.Number({"shake_hz", "Hz", "of the shake"}, trial.shake_hz, Between(0.1, 20.0));
  keys.Number({"drive_m_s", "m/s", "its driven wheels turn at this speed, away from the dock"},
              trial.drive_m_s, NonNegative(5.0));
  keys.Mapping(Unset("contact"), [&](Keys& in) { VisitContact(in, trial.contact); });
  keys.Mapping(Unset("pose"), [&](Keys& in) { VisitPose(in, trial.pose, false); });
  keys.Check("push_n", trial.push_n > 0.0 || trial.shake_n > 0.0 || trial.drive_m_s > 0.0,
             "a push_n, shake_n or drive_m_s above zero: without one the trial tries nothing");
}

}  // namespace

void VisitJudge(Keys& keys, JudgeKeys& judge) {
  keys.Mapping({"docked", "", "", kRequired}, [&](Keys& in) { VisitDocked(in, judge); });
  keys.Mapping(Unset("trial"), [&](Keys& in) { VisitTrial(in, judge.trial); });
  keys.Mapping({"dock_pushed", "", ""}, [&](Keys& in) {
    in.Number({"moved_m", "m", "a dock that is moved further was pushed"}, judge.pushed_m,
              Positive(10.0));
    in.Degrees({"turned_deg", "deg", "the same of its turn"}, judge.pushed_rad, Positive(180.0));
  });
  keys.Mapping({"collided", "", ""}, [&](Keys& in) {
    in.Number({"most_n", "N", "a larger sum of forces between robot and dock is a collision"},
              judge.collided_n, Positive(1e6));
  });
  keys.Mapping({"tipped_over", "", ""}, [&](Keys& in) {
    in.Degrees({"tilt_deg", "deg", "of the robot or the dock from upright"}, judge.tipped_rad,
               Between(5.0, 180.0));
  });
}

}  // namespace dockyard::custom
