#include "sim/raposa/trial.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dockyard::raposa {
namespace {

constexpr double kAway_m_s = 0.05, kBelt_m_s = 0.05;
// A turn that a soft ground or a pressed arm holds up is given this many times the time that it
// takes by the belts' gauge. Assumed, 3-10.
constexpr double kPatience = 6.0;

}  // namespace

Trial TryToDriveAway(World& world, const RobotModel& robot, const OutcomeLimits& limits,
                     const Commands& last, const std::function<void(const Truth&)>& watch) {
  Trial trial{.done = true};
  std::array<MotorCommand, kMotorCount> commands{};
  std::copy(last.motors.begin(), last.motors.end(), commands.begin());
  Truth now = world.truth();
  const auto drive = [&](double left_m_s, double right_m_s, const auto& over, double most_s) {
    const double speeds[2] = {left_m_s, right_m_s};
    for (std::size_t i = 0; i < 2; ++i) {
      const MotorModel& motor = robot.motors[i];
      commands[i] = {.mode = MotorMode::kVelocity,
                     .target = speeds[i] / robot.belts.roller_radius_m,
                     .accel_rad_s2 = motor.max_accel_rad_s2,
                     .current_limit_a = motor.max_current_a};
    }
    const Truth before = now;
    while (now.time_s - before.time_s < most_s && !over(before)) {
      for (const Tick until = world.tick() + kControlPeriod; world.tick() < until;)
        world.Step(commands);
      now = world.truth();
      trial.worst_m = std::max(trial.worst_m, now.p_SP_R.norm());
      watch(now);
    }
  };
  const auto gone = [&](const Truth& before) {
    return (now.X_WR.p - before.X_WR.p).norm() >= limits.trial_way_m;
  };
  const auto turned = [&](const Truth& before) {
    const Eigen::Matrix3d R = before.X_WR.R.transpose() * now.X_WR.R;
    return std::abs(std::atan2(R(1, 0), R(0, 0))) >= limits.trial_turn_rad;
  };
  drive(kAway_m_s, kAway_m_s, gone, kPatience * limits.trial_way_m / kAway_m_s);
  drive(-kBelt_m_s, kBelt_m_s, turned,
        kPatience * limits.trial_turn_rad * robot.belts.gauge_m / (2.0 * kBelt_m_s));
  return trial;
}

}  // namespace dockyard::raposa
