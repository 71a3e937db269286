#include "controller/rocky7/mast_drive.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// A joint has arrived within this of its target. Assumed, 0.1-0.5 deg.
constexpr double kJointThere_rad = Radians(0.25);
// And is held back when it is still this far off. Assumed, 1-4 deg.
constexpr double kJointMissed_rad = Radians(2.0);
// The mast is flexible (Washington University's page on Rocky 7's field test): it swings out after
// a move. Assumed, 0.5-2 s.
constexpr Tick kSwingsOut = 800;
// A joint that load holds back is left after so much more than its move takes. Assumed, 1-5 s.
constexpr double kJointPatience_s = 2.0;

}  // namespace

MastDrive::MastDrive(const Nominal& nominal)
    : nominal_(nominal), first_(FirstMastMotor(nominal)), commands_(kMastMotorCount) {}

MastAngles MastDrive::Angles(const SensorFrame& sensed) const {
  MastAngles angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = AngleOf(nominal_, sensed, first_ + i);
  return angles;
}

void MastDrive::Begin(const MastAngles& goal, double speed_share, const SensorFrame& sensed) {
  goal_ = goal;
  since_ = sensed.tick;
  there_ = false;
  const MastAngles now = Angles(sensed);
  std::array<double, kMastMotorCount> takes_s{};
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double way_rad = std::abs(goal[i] - now[i]);
    takes_s[i] = way_rad / (speed_share * nominal_.motors[first_ + i].max_speed_rad_s);
  }
  const double longest_s = *std::max_element(takes_s.begin(), takes_s.end());
  takes_s_ = longest_s;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const NominalMotor& motor = nominal_.motors[first_ + i];
    const double share = longest_s > 0.0 ? std::max(0.02, takes_s[i] / longest_s) : 1.0;
    const double speed_rad_s = share * speed_share * motor.max_speed_rad_s;
    commands_[i] = MoveTo(motor, goal[i], speed_rad_s, share);
    takes_s_ = std::max(takes_s_,
                        longest_s + speed_share * motor.max_speed_rad_s / motor.max_accel_rad_s2);
  }
}

void MastDrive::Follow(const MastAngles& goal) {
  goal_ = goal;
  for (std::size_t i = 0; i < goal.size(); ++i) {
    const NominalMotor& motor = nominal_.motors[first_ + i];
    commands_[i] = MoveTo(motor, goal[i], motor.max_speed_rad_s);
  }
}

bool MastDrive::Missed(const SensorFrame& sensed) const {
  const MastAngles now = Angles(sensed);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (std::abs(now[i] - goal_[i]) > kJointMissed_rad) return true;
  }
  return false;
}

bool MastDrive::Rests(const SensorFrame& sensed) {
  if (!there_) {
    const MastAngles now = Angles(sensed);
    bool all = true;
    for (std::size_t i = 0; i < now.size(); ++i) {
      all = all && std::abs(now[i] - goal_[i]) < kJointThere_rad;
    }
    const double since_s = static_cast<double>(sensed.tick - since_) * kTickSeconds;
    if (!all && since_s < takes_s_ + kJointPatience_s) return false;
    there_ = true;
    arrived_ = sensed.tick;
  }
  return sensed.tick - arrived_ >= kSwingsOut;
}

}  // namespace dockyard::rocky7
