#include "models/custom/make_nominal.h"

#include <algorithm>
#include <cmath>

namespace dockyard::custom {
namespace {

/// The motor on the joint that carries a link; -1: none.
int MotorOn(const RobotModel& robot, int link) {
  for (std::size_t i = 0; i < robot.motors.size(); ++i) {
    if (robot.motors[i].link == link) return static_cast<int>(i);
  }
  return -1;
}

/// The nearest link towards the root whose joint is upright; 0: none.
int UprightJointAbove(const RobotModel& robot, const std::vector<Pose3>& X_RL, int link) {
  constexpr double kUpright = 0.9;  // cosine
  for (int at = robot.tree.joint(link).carrier; at > 0; at = robot.tree.joint(at).carrier) {
    const JointedLink& joint = robot.tree.joint(at);
    const Eigen::Vector3d axis_R = X_RL[static_cast<std::size_t>(at)].R * joint.axis_L;
    if (!joint.slides && std::abs(axis_R.z()) > kUpright) return at;
  }
  return 0;
}

RobotWheel WheelOf(const RobotModel& robot, const std::vector<Pose3>& X_RL, const WheelFit& fit) {
  const Pose3& X_RK = X_RL[static_cast<std::size_t>(fit.link)];
  RobotWheel wheel{.link = robot.tree.link(fit.link).name,
                   .p_RK = X_RK * fit.p_LK,
                   .axle_R = X_RK.R * fit.axle_L,
                   .radius_m = fit.tyre.radius_m,
                   .width_m = fit.tyre.width_m,
                   .ball = fit.tyre.ball};
  if (fit.tyre.ball) return wheel;
  wheel.axle_R = X_RK.R * robot.tree.joint(fit.link).axis_L;
  wheel.drive = MotorOn(robot, fit.link);
  const int upright = UprightJointAbove(robot, X_RL, fit.link);
  if (upright == 0) return wheel;
  wheel.p_RS = X_RL[static_cast<std::size_t>(upright)].p;
  wheel.steering = MotorOn(robot, upright);
  wheel.swivels = wheel.steering < 0;
  return wheel;
}

}  // namespace

Nominal MakeNominal(const RobotModel& robot, const DockModel& dock) {
  Nominal nominal;
  nominal.name = robot.name;
  const std::vector<Pose3> X_RL = StartPoses(robot.tree);
  for (const MotorFit& motor : robot.motors) {
    nominal.motors.push_back({motor.joint, NominalOf(motor.model), motor.travel_per_rad});
  }
  for (const WheelFit& wheel : robot.wheels) {
    nominal.wheels.push_back(WheelOf(robot, X_RL, wheel));
    nominal.height_m =
        std::max(nominal.height_m, wheel.tyre.radius_m - nominal.wheels.back().p_RK.z());
  }
  for (const CameraFit& camera : robot.cameras) {
    nominal.cameras.push_back(
        {.name = camera.model.name,
         .camera = camera.model.nominal,
         .X_RC = X_RL[static_cast<std::size_t>(camera.link)] * camera.model.X_LC,
         .colour = camera.model.colour,
         .period_s = camera.model.period_s,
         .latency_s = camera.model.latency_s});
  }
  const std::vector<Pose3> X_DL = StartPoses(dock.tree);
  for (const BoardFit& board : dock.boards) {
    nominal.boards.push_back(
        {board.name, board.board, X_DL[static_cast<std::size_t>(board.link)] * board.X_LB});
  }
  return nominal;
}

}  // namespace dockyard::custom
