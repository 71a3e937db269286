#include "sim/custom/custom_judge.h"

#include <algorithm>
#include <cmath>

namespace dockyard::custom {
namespace {

// After a claim the robot comes to rest. Assumed, 0.2-1 s.
constexpr double kSettle_s = 0.5;

}  // namespace

CustomJudge::CustomJudge(CustomPlant& plant)
    : plant_(plant), keys_(plant.built().judge), X_GR_last_(ToGround(plant.truth().X_GR)) {}

void CustomJudge::Observe() {
  const Truth& truth = plant_.truth();
  const Pose2 now = ToGround(truth.X_GR);
  measures_.driven_m += std::hypot(now.x - X_GR_last_.x, now.y - X_GR_last_.y);
  X_GR_last_ = now;
  const ContactTruth* contact = plant_.Contact(keys_.docked.contact.pins);
  was_closed_ = was_closed_ || (contact != nullptr && contact->closed);
}

bool CustomJudge::fatal() const {
  const Truth& truth = plant_.truth();
  return std::max(truth.tilt_rad, truth.dock_tilt_rad) > keys_.tipped_rad ||
         truth.peak_touch_n > keys_.collided_n;
}

bool CustomJudge::IsDocked() const {
  const Truth& truth = plant_.truth();
  const Condition& docked = keys_.docked;
  return Holds(docked.pose, truth.X_QP) &&
         Holds(docked.contact, plant_.Contact(docked.contact.pins)) &&
         (std::isnan(docked.most_n) || truth.touch_n <= docked.most_n) &&
         (std::isnan(docked.most_m_s) || truth.speed_m_s <= docked.most_m_s);
}

bool CustomJudge::KeepsInTrial() const {
  const TrialKeys& trial = keys_.trial;
  return Holds(trial.pose, plant_.truth().X_QP) &&
         Holds(trial.contact, plant_.Contact(trial.contact.pins));
}

template <class Keeps>
bool CustomJudge::Play(const Commands& commands, double seconds, const char* phase,
                       const TrialWatch& watch, const Keeps& keeps) {
  bool kept = true;
  const Tick until = plant_.tick() + std::llround(seconds / kTickSeconds);
  while (plant_.tick() < until) {
    plant_.RefreshTruth();
    Observe();
    watch(phase);
    kept = kept && keeps();
    plant_.Advance(commands);
  }
  plant_.RefreshTruth();
  return kept && keeps();
}

// The driven wheels turn so that the robot leaves the dock.
Commands CustomJudge::DriveAway(const Commands& last) const {
  Commands away = last;
  const RobotModel& robot = plant_.built().world.robot;
  const double forward = plant_.truth().X_DR.R(0, 0) >= 0.0 ? 1.0 : -1.0;
  for (const WheelFit& wheel : robot.wheels) {
    for (std::size_t i = 0; i < robot.motors.size(); ++i) {
      if (robot.motors[i].link != wheel.link) continue;
      const JointedLink& joint = robot.tree.joint(wheel.link);
      const double sign = joint.axis_L.dot(wheel.axle_L) >= 0.0 ? forward : -forward;
      const MotorModel& motor = robot.motors[i].model;
      away.motors[i] = {.mode = MotorMode::kVelocity,
                        .target = sign * keys_.trial.drive_m_s / wheel.tyre.radius_m,
                        .speed_limit_rad_s = 0.0,
                        .accel_rad_s2 = motor.max_accel_rad_s2,
                        .current_limit_a = motor.max_current_a};
    }
  }
  return away;
}

std::string CustomJudge::Try(const Commands& last, const TrialWatch& watch) {
  const TrialKeys& trial = keys_.trial;
  const auto keeps = [&] { return KeepsInTrial(); };
  std::string lost_in;
  const auto note = [&](bool kept, const std::string& part) {
    if (!kept && lost_in.empty()) lost_in = part;
  };
  if (trial.push_n > 0.0) {
    int push = 0;
    for (const double towards : trial.towards_rad) {
      plant_.Push(trial.push_n * Eigen::Vector3d(std::cos(towards), std::sin(towards), 0.0), 0.0);
      note(Play(last, trial.for_s, "push", watch, keeps), "push " + std::to_string(++push));
      plant_.Push(Eigen::Vector3d::Zero(), 0.0);
    }
  }
  if (trial.shake_n > 0.0) {
    plant_.Push(Eigen::Vector3d(0.0, trial.shake_n, 0.0), trial.shake_hz);
    note(Play(last, trial.for_s, "shake", watch, keeps), "shake");
    plant_.Push(Eigen::Vector3d::Zero(), 0.0);
  }
  if (trial.drive_m_s > 0.0) {
    note(Play(DriveAway(last), trial.for_s, "drive_away", watch, keeps), "drive");
  }
  return lost_in;
}

Conclusion CustomJudge::Conclude(const Commands& last, const Belief& belief,
                                 const TrialWatch& watch) {
  EndOfRun end{.claimed = last.verdict,
               .phase = belief.phase,
               .said = belief.note,
               .truth = {},
               .contact = {}};
  const auto docked = [&] { return IsDocked(); };
  if (last.verdict == Verdict::kDone) {
    Play(last, kSettle_s, "rest", watch, docked);
    end.held = Play(last, keys_.hold_s, "hold", watch, docked);
  }
  plant_.RefreshTruth();
  Observe();
  end.truth = plant_.truth();
  const bool tries =
      keys_.trial.push_n > 0.0 || keys_.trial.shake_n > 0.0 || keys_.trial.drive_m_s > 0.0;
  if (end.held && tries) {
    end.tried = true;
    end.lost_in = Try(last, watch);
    end.kept = end.lost_in.empty();
  }
  if (const ContactTruth* contact =
          Find(end.truth, plant_.built().world.contacts, keys_.docked.contact.pins)) {
    end.contact = *contact;
    end.contact_asked = true;
  }
  end.was_closed = was_closed_;
  measures_.pin_offset_m = end.contact.offset_m;
  measures_.contact_force_n = end.contact.force_n;
  measures_.contact_voltage_v = end.contact.voltage_v;
  measures_.off_x_m = end.truth.X_QP.p.x();
  measures_.off_y_m = end.truth.X_QP.p.y();
  measures_.off_yaw_deg = Degrees(ToRollPitchYaw(end.truth.X_QP.R).yaw);
  measures_.peak_touch_n = end.truth.peak_touch_n;
  measures_.dock_moved_m = end.truth.dock_moved_m;
  measures_.retries = ValueOf(belief, "retries", 0.0);
  const Judged judged = JudgeEnd(end, keys_);
  return {Name(judged.outcome), judged.note, Values(measures_), LimitsOf(end, keys_)};
}

}  // namespace dockyard::custom
