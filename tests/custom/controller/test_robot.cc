#include "custom/controller/test_robot.h"

namespace dockyard::custom {

Pose3 CameraAt(const Eigen::Vector3d& p_RC, double yaw_rad) {
  Eigen::Matrix3d R;  // columns: x right, y down, z along the view
  R << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return {RotZ(yaw_rad) * R, p_RC};
}

Eigen::Matrix3d TurnAbout(const Eigen::Vector3d& turn_rad) {
  const double angle = turn_rad.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn_rad / angle).toRotationMatrix();
}

Pose3 Mirrored(const Pose3& X_CB) {
  const Eigen::Vector3d sight = X_CB.p.normalized();
  Pose3 other = X_CB;
  for (int i = 0; i < 2; ++i) other.R.col(i) -= 2.0 * sight.dot(X_CB.R.col(i)) * sight;
  other.R.col(2) = other.R.col(0).cross(other.R.col(1));
  return other;
}

Nominal NominalOf(const TestRobot& robot) {
  Nominal nominal;
  nominal.name = "test robot";
  nominal.height_m = 0.0;
  nominal.has_imu = true;
  const NominalMotor motor{.rad_per_count = 0.001,
                           .torque_per_amp_nm = 1.0,
                           .max_current_a = 5.0,
                           .max_speed_rad_s = 10.0,
                           .max_accel_rad_s2 = 40.0};
  nominal.motors = {{"left", motor, robot.left_travel_per_rad},
                    {"right", motor, robot.right_travel_per_rad}};
  const auto wheel = [&](const std::string& link, double y, double axle, int drive) {
    RobotWheel made;
    made.link = link;
    made.p_RK = {robot.axle_x_m, y, robot.radius_m};
    made.axle_R = {0.0, axle, 0.0};
    made.radius_m = robot.radius_m;
    made.width_m = 0.03;
    made.drive = drive;
    return made;
  };
  RobotWheel caster = wheel("caster", 0.0, 1.0, -1);
  caster.p_RK = {robot.axle_x_m - 0.2, 0.0, 0.03};
  caster.swivels = true;
  nominal.wheels = {wheel("left wheel", 0.5 * robot.gauge_m, robot.left_axle, 0),
                    wheel("right wheel", -0.5 * robot.gauge_m, robot.right_axle, 1), caster};

  const double front = robot.rear_camera ? -1.0 : 1.0;
  nominal.cameras = {{.name = "camera",
                      .camera = EquidistantCamera(640, 480, Radians(70.0)),
                      .X_RC = CameraAt({0.15 * front, 0.0, 0.25}, front > 0.0 ? 0.0 : kPi),
                      .period_s = 0.033,
                      .latency_s = 0.1}};
  DockBoard board;
  board.name = "board";
  board.board = {.width_m = 0.14, .height_m = 0.14, .disc_diameter_m = 0.03, .fiducials = {}};
  for (int i = 0; i < 9; ++i)
    board.board.fiducials.push_back({.p_BF = {0.045 * (i % 3 - 1), 0.045 * (i / 3 - 1)}});
  Eigen::Matrix3d R_DB;  // columns: x right of a viewer at +x of D, y down, z into the dock
  R_DB << 0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  board.X_DB = {R_DB, {-0.1, 0.0, 0.25}};
  nominal.boards = {board};

  const double nose = robot.docks_backward ? -0.25 : 0.25;
  nominal.X_RP = Pose3::Translation(nose, 0.0, 0.1);
  nominal.X_DQ = {RotZ(robot.docks_backward ? 0.0 : kPi), {0.0, 0.0, 0.1}};
  if (robot.contact) {
    nominal.contact = "charger";
    nominal.contact_voltage_v = 12.0;
    nominal.sensors = {"charger_voltage_v"};
  }
  return nominal;
}

}  // namespace dockyard::custom
