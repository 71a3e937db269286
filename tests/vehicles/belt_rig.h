// A rigid body on belts, with no other contact: Newton's and Euler's laws, semi-implicit Euler.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <utility>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/vehicles/belt.h"

namespace dockyard {

/// A belt with the pose of the link that carries it, fixed to the body.
struct RigBelt {
  Pose3 X_RL;
  BeltModel model;
  double speed_m_s = 0.0;
  BeltLoad load{};  // of the last step
};

struct BeltRig {
  std::vector<RigBelt> belts;
  std::vector<Belt> contacts;  // by belts
  HeightGrid ground = LevelGrid(-3.0, 6.0, 6.0, 0.1);
  double mass_kg = 27.0;
  Eigen::Vector3d p_RCom = Eigen::Vector3d::Zero();
  Eigen::Vector3d inertia_kg_m2{0.6, 0.9, 1.3};  // about the centre of mass, along R's axes
  Eigen::Vector3d gravity_G{0.0, 0.0, -9.81};
  Pose3 X_GR;
  Eigen::Vector3d v_GCom_G = Eigen::Vector3d::Zero(), w_GR_G = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_G = Eigen::Vector3d::Zero();  // at the centre of mass [N]
  double twist_nm = 0.0;                             // about G's z

  void PutOn(const BeltGround& on) {
    contacts.clear();
    for (const RigBelt& belt : belts) contacts.emplace_back(belt.model, on);
  }
  void PutOn(const SoilModel& soil, double rolling_loss) {
    contacts.clear();
    for (const RigBelt& belt : belts) contacts.emplace_back(belt.model, soil, rolling_loss);
  }
  /// Its weight grows from nothing, so that it presses no deeper than its weight at rest.
  void LayDown(double seconds, double dt_s = 1e-3) {
    const Eigen::Vector3d full_G = gravity_G;
    for (int i = 1; i <= 100; ++i) {
      gravity_G = 0.01 * i * full_G;
      Run(0.01 * seconds, dt_s);
    }
  }
  LinkMotion MotionOf(const RigBelt& belt) const {
    const Pose3 X_GL = X_GR * belt.X_RL;
    return {X_GL, v_GCom_G + w_GR_G.cross(X_GL.p - X_GR * p_RCom), w_GR_G};
  }
  /// Velocity of R's origin, in R.
  Eigen::Vector3d VelocityInR() const {
    return X_GR.R.transpose() * (v_GCom_G + w_GR_G.cross(X_GR.p - X_GR * p_RCom));
  }
  /// Loads all belts; force and torque about the centre of mass.
  std::pair<Eigen::Vector3d, Eigen::Vector3d> Load(double dt_s) {
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
    const Eigen::Vector3d com = X_GR * p_RCom;
    for (std::size_t i = 0; i < belts.size(); ++i) {
      const LinkMotion motion = MotionOf(belts[i]);
      belts[i].load = contacts[i].Step(ground, motion, belts[i].speed_m_s, dt_s);
      force += belts[i].load.force_G;
      torque += belts[i].load.torque_G + (motion.X_GL.p - com).cross(belts[i].load.force_G);
    }
    return {force, torque};
  }
  void Step(double dt_s) {
    const auto [force, torque] = Load(dt_s);
    const Eigen::Matrix3d I_G = X_GR.R * inertia_kg_m2.asDiagonal() * X_GR.R.transpose();
    v_GCom_G += dt_s * (gravity_G + (force + push_G) / mass_kg);
    w_GR_G += dt_s * I_G.inverse() *
              (torque + twist_nm * Eigen::Vector3d::UnitZ() - w_GR_G.cross(I_G * w_GR_G));
    const Eigen::Vector3d com = X_GR * p_RCom + dt_s * v_GCom_G;
    const double turn = w_GR_G.norm() * dt_s;
    if (turn > 0.0) {
      X_GR.R = Eigen::AngleAxisd(turn, w_GR_G.normalized()).toRotationMatrix() * X_GR.R;
    }
    X_GR.p = com - X_GR.R * p_RCom;
  }
  void Run(double seconds, double dt_s = 1e-3) {
    for (long i = std::lround(seconds / dt_s); i > 0; --i) Step(dt_s);
  }
  void Drive(double left_m_s, double right_m_s) {
    for (RigBelt& belt : belts) belt.speed_m_s = belt.model.y_m > 0.0 ? left_m_s : right_m_s;
  }
  double Weight() const { return mass_kg * gravity_G.norm(); }
};

/// Two belts 0.386 m long and 0.07 m wide bear as a spring of 1e6 N/m, damped by half of the
/// critical under 27 kg. Assumed, ranges 2e5-1e6 N/m and a quarter to all of critical. Under 5 kPa
/// rubber with friction 0.6 shears by 1 mm before it slides. Assumed, range 0.3-3 mm.
inline BeltModel RigBeltModel(double rear_m, double front_m, double radius_m, double y_m,
                              double pad_m) {
  BeltModel belt;
  belt.front = {front_m, 0.0, radius_m};
  belt.rear = {rear_m, 0.0, radius_m};
  belt.y_m = y_m;
  belt.width_m = 0.07;
  belt.pads =
      static_cast<int>(std::lround((2.0 * (front_m - rear_m) + 2.0 * kPi * radius_m) / pad_m));
  belt.sprocket_radius_m = radius_m;
  belt.stiffness_pa_per_m = 1.8e7;
  belt.damping_pa_s_per_m = 7e4;
  belt.shear_stiffness_pa_per_m = 3e6;
  belt.shear_damping_pa_s_per_m = 3e4;
  return belt;
}

/// Two belts of this length and gauge under a centre of mass that lies ahead of their middle. The
/// rollers are small, so that the belts bear along their straight runs only.
inline BeltRig TwoBelts(double length_m, double gauge_m, double ahead_m = 0.0,
                        const BeltGround& ground = kHardFloor) {
  const double radius_m = 0.03;
  BeltRig rig;
  for (const double y_m : {0.5 * gauge_m, -0.5 * gauge_m}) {
    rig.belts.push_back(
        {{}, RigBeltModel(-0.5 * length_m, 0.5 * length_m, radius_m, y_m, 0.0155), 0.0});
  }
  rig.p_RCom = {ahead_m, 0.0, 0.0};
  rig.X_GR.p.z() = radius_m;
  rig.PutOn(ground);
  return rig;
}

/// A robot of 27 kg with main belts and a frontal arm on belts of its own, which run with them. Its
/// origin is at the height of the axles, x towards the arm. Assumed: axles at -0.240 (-0.28 to
/// -0.20) and 0.146 m, where the arm's joint is; arm 0.18 m (0.15-0.25); rollers 0.09 m; gauge
/// 0.426 m; body 22 kg at x -0.05 m (-0.08 to -0.02), arm 5 kg (3-7) at half its length.
inline BeltRig ArmedRobot(double arm_down_rad, const BeltGround& ground = kHardFloor) {
  const double gauge_m = 0.426, radius_m = 0.09, joint_m = 0.146, arm_m = 0.18;
  const Pose3 X_RA{Eigen::AngleAxisd(arm_down_rad, Eigen::Vector3d::UnitY()).toRotationMatrix(),
                   {joint_m, 0.0, 0.0}};
  BeltRig rig;
  for (const double y_m : {0.5 * gauge_m, -0.5 * gauge_m}) {
    rig.belts.push_back({{}, RigBeltModel(-0.240, joint_m, radius_m, y_m, 0.028), 0.0});
    rig.belts.push_back({X_RA, RigBeltModel(0.0, arm_m, radius_m, y_m, 0.028), 0.0});
  }
  const double body_kg = 22.0, arm_kg = 5.0;
  rig.p_RCom = (body_kg * Eigen::Vector3d(-0.05, 0.0, -0.01) +
                arm_kg * (X_RA * Eigen::Vector3d(0.5 * arm_m, 0.0, 0.0))) /
               (body_kg + arm_kg);
  // A pressed arm lifts the front until both outer rollers stand: Lw sin b = la sin(theta - b).
  const double down_rad = std::max(0.0, arm_down_rad), axles_m = joint_m + 0.240;
  const double up_rad =
      std::atan2(arm_m * std::sin(down_rad), axles_m + arm_m * std::cos(down_rad));
  rig.X_GR.R = Eigen::AngleAxisd(-up_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
  rig.X_GR.p.z() = radius_m + 0.240 * std::sin(up_rad);
  rig.PutOn(ground);
  return rig;
}

/// How the body turns: rate, effective gauge (belts' speeds over the rate) and where along x the
/// point lies that does not move sideways.
struct Turning {
  double rate_rad_s = 0.0, gauge_m = 0.0, centre_m = 0.0;
  double ripple = 0.0;  // largest change of the rate, over the rate
};

/// Settles, turns in place with these belt speeds, and averages over the last second.
inline Turning TurnInPlace(BeltRig& rig, double belt_m_s = 0.1, double dt_s = 1e-3) {
  rig.Run(0.5, dt_s);
  rig.Drive(-belt_m_s, belt_m_s);
  rig.Run(5.0, dt_s);  // the longest belts are past once
  double rate = 0.0, sideways = 0.0, least = 1e9, most = -1e9;
  const long steps = std::lround(1.0 / dt_s);
  for (long i = 0; i < steps; ++i) {
    rig.Step(dt_s);
    const double now = rig.w_GR_G.z();
    rate += now / steps;
    sideways += rig.VelocityInR().y() / steps;
    least = std::min(least, now);
    most = std::max(most, now);
  }
  return {rate, 2.0 * belt_m_s / rate, -sideways / rate, (most - least) / rate};
}

}  // namespace dockyard
