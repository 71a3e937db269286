// A wheel's place and motion in the forms that its patches need, and the sum of their loads.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "controller/geometry/pose.h"

namespace dockyard {

/// Where a wheel is and how it moves, in the site frame G. The wheel frame K turns with the wheel.
struct WheelMotion {
  Pose3 X_GK;
  Eigen::Vector3d v_GK_G = Eigen::Vector3d::Zero();  // of the wheel's centre [m/s]
  Eigen::Vector3d w_GK_G = Eigen::Vector3d::Zero();  // [rad/s], spin included
};

/// Axes and motion of the spoke (cos, 0, -sin) in K: r outwards, t the way a point of the rim goes
/// when the wheel turns forward, a along the axle.
struct SpokeAxes {
  Eigen::Vector3d r_G;
  double cos = 0.0, sin = 0.0;
  double t_z = 0.0, a_z = 0.0;  // how t and a climb
  double v_r = 0.0, v_t = 0.0, v_a = 0.0;
  double w_r = 0.0, w_t = 0.0, w_a = 0.0;
};

/// Velocity of a point of the wheel along its spoke's axes [m/s].
struct SpokeVelocity {
  double r = 0.0, t = 0.0, a = 0.0;
};
inline SpokeVelocity VelocityAt(const SpokeAxes& axes, double radius_m, double y_m) {
  return {axes.v_r + y_m * axes.w_t, axes.v_t + radius_m * axes.w_a - y_m * axes.w_r,
          axes.v_a - radius_m * axes.w_t};
}

struct WheelFrame {
  Eigen::Vector3d p_G, x_G, y_G, z_G;  // centre and axes of K
  Eigen::Vector3d v_K, w_K;
  double top_m = 0.0;  // ground is nowhere higher than this near the wheel
  double dt_s = 0.0;

  WheelFrame(const WheelMotion& motion, double step_s) : dt_s(step_s) {
    const Eigen::Matrix3d& R = motion.X_GK.R;
    p_G = motion.X_GK.p;
    x_G = R.col(0);
    y_G = R.col(1);
    z_G = R.col(2);
    v_K = R.transpose() * motion.v_GK_G;
    w_K = R.transpose() * motion.w_GK_G;
  }

  SpokeAxes Along(double cos, double sin) const {
    SpokeAxes axes;
    axes.r_G = cos * x_G - sin * z_G;
    axes.cos = cos;
    axes.sin = sin;
    axes.t_z = -sin * x_G.z() - cos * z_G.z();
    axes.a_z = y_G.z();
    axes.v_r = v_K.x() * cos - v_K.z() * sin;
    axes.v_t = -v_K.x() * sin - v_K.z() * cos;
    axes.v_a = v_K.y();
    axes.w_r = w_K.x() * cos - w_K.z() * sin;
    axes.w_t = -w_K.x() * sin - w_K.z() * cos;
    axes.w_a = w_K.y();
    return axes;
  }
};

/// Load on the wheel along a spoke's axes [N].
struct SpokeLoad {
  double r = 0.0, t = 0.0, a = 0.0;
};

/// Force and torque on the wheel in K.
struct LoadSum {
  Eigen::Vector3d force_K = Eigen::Vector3d::Zero(), torque_K = Eigen::Vector3d::Zero();
  double sinkage_m = 0.0;  // of the lowest patch
  bool in_contact = false;

  void Touch(double depth_m) {
    sinkage_m = std::max(sinkage_m, depth_m);
    in_contact = true;
  }
  /// A load on the spoke at this radius, with its moments about the spoke's foot on the axle: the
  /// parts about r and t that its place across the width gives.
  void Add(const SpokeAxes& axes, double radius_m, const SpokeLoad& load, double about_r_nm,
           double about_t_nm) {
    const double c = axes.cos, s = axes.sin;
    const double turn_t = about_t_nm - radius_m * load.a;
    force_K += Eigen::Vector3d(load.r * c - load.t * s, load.a, -load.r * s - load.t * c);
    torque_K += Eigen::Vector3d(about_r_nm * c - turn_t * s, radius_m * load.t,
                                -about_r_nm * s - turn_t * c);
  }
  void AddAt(const SpokeAxes& axes, double radius_m, double y_m, const SpokeLoad& load) {
    Add(axes, radius_m, load, -y_m * load.t, y_m * load.r);
  }
};

}  // namespace dockyard
