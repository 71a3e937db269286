// Rocky 7's nominal parameters, written down for tests of its controllers alone.
#pragma once

#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

inline Nominal NominalRover() {
  Nominal nominal;
  nominal.plan.name = "rocky7";
  for (const double y : {0.2, -0.2}) nominal.plan.wheels.push_back({"front", {0.409, y}, 1.2});
  for (const double x : {0.069, -0.069}) {
    for (const double y : {0.2, -0.2}) nominal.plan.wheels.push_back({"fixed", {x, y}});
  }
  nominal.plan.wheel_radius_m = nominal.rolling_radius_m = 0.07;
  nominal.plan.p_RP = {0.6, 0.0};
  nominal.plan.speed_m_s = 0.05;
  nominal.plan.steer_rate_rad_s = 0.5;
  nominal.motors.assign(6, {1e-4, 2.0, 0.1, 2.0, 1.5, 1.5});
  nominal.motors.resize(8, {1e-4, 4.0, 0.1, 2.0, 0.5, 2.0});
  nominal.motors.resize(10, {1e-4, 3.0, 0.1, 2.0, 0.5, 1.0});
  nominal.motors.resize(12, {1e-4, 0.6, 0.1, 1.1, 1.0, 5.0});
  nominal.motors.resize(15, {1e-4, 10.0, 0.1, 2.0, 0.3, 0.5});
  nominal.arm = {{0.36, 0.0, 0.13}, 0.32, 0.05, 1.85};
  nominal.front.left = nominal.front.right = EquidistantCamera(640, 480, Radians(103.0));
  Eigen::Matrix3d R_level;
  R_level.col(0) = -Eigen::Vector3d::UnitY();
  R_level.col(1) = -Eigen::Vector3d::UnitZ();
  R_level.col(2) = Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d R = RotY(Radians(45.0)) * R_level;
  nominal.front.X_RL = {R, Eigen::Vector3d(0.4, 0.05, 0.23)};
  nominal.front.X_RQ = {R, Eigen::Vector3d(0.4, -0.05, 0.23)};
  nominal.back = nominal.front;
  nominal.mast.p_RM = {0.05, 0.0, 0.28};
  nominal.mast.link1_m = nominal.mast.link2_m = 0.5;
  nominal.mast.low_rad = {Radians(-170.0), Radians(-180.0), Radians(-10.0)};
  nominal.mast.high_rad = {Radians(170.0), 0.0, Radians(180.0)};
  nominal.mast.stowed_rad = {0.0, Radians(-90.0), Radians(170.0)};
  nominal.mast.watch_rad = {0.0, Radians(-90.0), Radians(102.0)};
  nominal.mast.switch_radius_m = 0.028;
  nominal.mast.pair_K.left = nominal.mast.pair_K.right = EquidistantCamera(640, 480, Radians(43.0));
  nominal.mast.pair_K.X_RL = {R_level, Eigen::Vector3d(0.4, 0.1, 0.07)};
  nominal.mast.pair_K.X_RQ = {R_level, Eigen::Vector3d(0.4, -0.1, 0.07)};
  nominal.target_px = {320.0, 100.0};
  return nominal;
}

}  // namespace dockyard::rocky7
