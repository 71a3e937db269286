// A wheel's place and motion in the forms that its patches need, and the sum of their loads.
#pragma once

#include <Eigen/Core>
#include <type_traits>

#include "controller/geometry/pose.h"
#include "sim/soil/four.h"

namespace dockyard {

/// Where a wheel is and how it moves, in the site frame G. The wheel frame K turns with the wheel.
struct WheelMotion {
  Pose3 X_GK;
  Eigen::Vector3d v_GK_G = Eigen::Vector3d::Zero();  // of the wheel's centre [m/s]
  Eigen::Vector3d w_GK_G = Eigen::Vector3d::Zero();  // [rad/s], spin included
};

/// Axes and motion of the spoke (cos, 0, -sin) in K: r outwards, t the way a point of the rim goes
/// when the wheel turns forward, a along the axle. Real is double, or Four for four spokes.
template <typename Real>
struct SpokeAxesOf {
  Real r_x = 0.0, r_y = 0.0, r_z = 0.0;  // r in G
  Real cos = 0.0, sin = 0.0;
  Real t_z = 0.0;    // how t climbs
  double a_z = 0.0;  // and the axle
  Real v_r = 0.0, v_t = 0.0;
  double v_a = 0.0;
  Real w_r = 0.0, w_t = 0.0;
  double w_a = 0.0;
};
using SpokeAxes = SpokeAxesOf<double>;

/// Velocity of a point of the wheel along its spoke's axes [m/s].
template <typename Real>
struct SpokeVelocityOf {
  Real r = 0.0, t = 0.0, a = 0.0;
};
using SpokeVelocity = SpokeVelocityOf<double>;

template <typename Real>
SpokeVelocityOf<Real> VelocityAt(const SpokeAxesOf<Real>& axes, std::type_identity_t<Real> radius_m,
                                 std::type_identity_t<Real> y_m) {
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

  template <typename Real>
  SpokeAxesOf<Real> Along(Real cos, Real sin) const {
    SpokeAxesOf<Real> axes;
    axes.r_x = cos * x_G.x() - sin * z_G.x();
    axes.r_y = cos * x_G.y() - sin * z_G.y();
    axes.r_z = cos * x_G.z() - sin * z_G.z();
    axes.cos = cos;
    axes.sin = sin;
    axes.t_z = -(sin * x_G.z()) - cos * z_G.z();
    axes.a_z = y_G.z();
    axes.v_r = cos * v_K.x() - sin * v_K.z();
    axes.v_t = -(sin * v_K.x()) - cos * v_K.z();
    axes.v_a = v_K.y();
    axes.w_r = cos * w_K.x() - sin * w_K.z();
    axes.w_t = -(sin * w_K.x()) - cos * w_K.z();
    axes.w_a = w_K.y();
    return axes;
  }
};

/// Load on the wheel along a spoke's axes [N].
template <typename Real>
struct SpokeLoadOf {
  Real r = 0.0, t = 0.0, a = 0.0;
};
using SpokeLoad = SpokeLoadOf<double>;

/// Force and torque on the wheel in K, of one spoke after another or of four at a time.
template <typename Real>
struct LoadSumOf {
  Real force_x = 0.0, force_y = 0.0, force_z = 0.0, torque_x = 0.0, torque_y = 0.0, torque_z = 0.0;
  Real sinkage_m = 0.0;  // of the lowest patch; 0 where none touches

  void Touch(Real depth_m) { sinkage_m = Max(sinkage_m, depth_m); }
  /// A load on the spoke at this radius, with its moments about the spoke's foot on the axle: the
  /// parts about r and t that its place across the width gives.
  void Add(const SpokeAxesOf<Real>& axes, Real radius_m, const SpokeLoadOf<Real>& load,
           Real about_r_nm, Real about_t_nm) {
    const Real c = axes.cos, s = axes.sin;
    const Real turn_t = about_t_nm - radius_m * load.a;
    force_x += load.r * c - load.t * s;
    force_y += load.a;
    force_z -= load.r * s + load.t * c;
    torque_x += about_r_nm * c - turn_t * s;
    torque_y += radius_m * load.t;
    torque_z -= about_r_nm * s + turn_t * c;
  }
  void AddAt(const SpokeAxesOf<Real>& axes, Real radius_m, Real y_m,
             const SpokeLoadOf<Real>& load) {
    Add(axes, radius_m, load, -y_m * load.t, y_m * load.r);
  }
};
using LoadSum = LoadSumOf<double>;

/// The four spokes' sums in one.
inline LoadSum Together(const LoadSumOf<Four>& four) {
  return {Sum(four.force_x),  Sum(four.force_y),  Sum(four.force_z),      Sum(four.torque_x),
          Sum(four.torque_y), Sum(four.torque_z), Largest(four.sinkage_m)};
}

}  // namespace dockyard
