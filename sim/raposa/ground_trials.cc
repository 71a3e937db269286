#include "sim/raposa/ground_trials.h"

#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/raposa/tracks.h"

namespace dockyard::raposa {
namespace {

constexpr double kPress_s = 3.0, kStart_s = 2.0, kMeasure_s = 3.0;

double HeadingOf(const Truth& truth) { return std::atan2(truth.X_WR.R(1, 0), truth.X_WR.R(0, 0)); }

}  // namespace

BeltTrialResult TryBelt(const RobotModel& robot, const GroundModel& ground,
                        const BeltTrial& trial) {
  const BeltModel model = BodyBeltOf(robot, 0.0);
  return RunBelt(model, BeltOn({ground}, model), trial);
}

TurningResult TryTurning(const WorldSetup& base, double arm_rad, double belt_m_s) {
  World world(base);
  MotorCommands rest{};
  rest[2] = GoTo(base, Motor::kArm, arm_rad);
  Play(world, base, rest, kPress_s);
  MotorCommands turn = Belts(base, -belt_m_s, belt_m_s);
  turn[2] = rest[2];
  Play(world, base, turn, kStart_s);
  TurningResult result;
  const long steps = std::lround(kMeasure_s / base.step_s);
  double turned_rad = 0.0, belts_m = 0.0;
  Eigen::Vector2d drift = Eigen::Vector2d::Zero();
  double heading = HeadingOf(world.truth());
  for (long i = 0; i < steps; ++i) {
    world.Step(turn);
    const Truth now = world.truth();
    turned_rad += WrapPi(HeadingOf(now) - heading);
    heading = HeadingOf(now);
    const Eigen::Vector3d v_R = now.X_WR.R.transpose() * now.v_WR_W;
    drift += base.step_s * v_R.head<2>();
    const MotorTruth &left = now.motors[0], &right = now.motors[1];
    belts_m +=
        base.step_s * base.robot.belts.roller_radius_m * (right.speed_rad_s - left.speed_rad_s);
    result.current_a +=
        0.5 * (std::abs(left.current_a) + std::abs(right.current_a)) / static_cast<double>(steps);
    result.torque_nm +=
        0.5 * (std::abs(left.torque_nm) + std::abs(right.torque_nm)) / static_cast<double>(steps);
  }
  result.turn_rad_s = turned_rad / kMeasure_s;
  result.gauge_m = belts_m / turned_rad;
  result.centre_m = -drift.y() / turned_rad;  // there v_y + w x is 0
  return result;
}

}  // namespace dockyard::raposa
