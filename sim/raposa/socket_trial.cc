#include "sim/raposa/socket_trial.h"

#include <cmath>

namespace dockyard::raposa {
namespace {

constexpr double kLast_m = 0.12;       // driven in
constexpr double kHeld_m = 3e-3;       // of a guide on its seat
constexpr double kPress_s = 3.0;       // for the arm to come down
constexpr double kStop_s = 0.3;        // before the doors begin
constexpr double kClose_s = 6.5;       // for the doors: 30 mm take 5 s
constexpr double kMostDrive_s = 60.0;  // in which the robot has come there or never will

/// Where the robot's origin is with the guide in its seat, as the arm leans the body.
double SeatOf(const RobotModel& robot, double arm_rad) {
  const BeltsModel& belts = robot.belts;
  const double lean =
      std::atan2(belts.arm_length_m * std::sin(arm_rad),
                 belts.body_front_m - belts.body_rear_m + belts.arm_length_m * std::cos(arm_rad));
  return -(robot.socket.p_RS.x() * std::cos(lean) - robot.socket.p_RS.z() * std::sin(lean));
}

}  // namespace

SocketResult TrySocket(const WorldSetup& base, const SocketTrial& trial) {
  WorldSetup setup = base;
  setup.pyramid.guide.height_m += trial.high_m;
  const double end_m = SeatOf(setup.robot, trial.arm_rad) + trial.short_m;
  // Where the robot is kLast_m before that place.
  const Pose2 X_DR{end_m + kLast_m * std::cos(trial.turned_rad),
                   trial.aside_m + kLast_m * std::sin(trial.turned_rad), trial.turned_rad};
  const Eigen::Vector3d& p_RC = setup.robot.camera.X_RC.p;
  setup.X_DV_start = X_DR * Pose2{p_RC.x(), p_RC.y(), kPi};
  World world(setup);
  MotorCommands commands{};
  commands[2] = GoTo(setup, Motor::kArm, trial.arm_rad);
  Play(world, setup, commands, kPress_s);
  MotorCommands in = Belts(setup, -trial.speed_m_s, -trial.speed_m_s);
  in[2] = commands[2];
  const long most_steps = std::lround(kMostDrive_s / setup.step_s);
  for (long i = 0; i < most_steps && world.truth().X_WR.p.x() - setup.X_GD.x > end_m; ++i) {
    world.Step(in);
  }
  Play(world, setup, commands, kStop_s);
  SocketResult result;
  result.pushed_m = world.truth().pyramid_shift_m;
  result.before_m = world.truth().p_SP_R.x();
  const double closed_rad = setup.robot.doors.travel_m / setup.robot.doors.pinion_radius_m;
  commands[3] = GoTo(setup, Motor::kLeftDoor, closed_rad);
  commands[4] = GoTo(setup, Motor::kRightDoor, closed_rad);
  Play(world, setup, commands, kClose_s);
  result.seat_m = world.truth().p_SP_R.norm();
  result.held = result.seat_m < kHeld_m;
  result.peak_n = world.truth().contact_peak_n;
  return result;
}

}  // namespace dockyard::raposa
