// A toy underwater body with six degrees of freedom: added mass, drag, weight and buoyancy, a
// uniform current, thrusters, and a cage of springs.
#pragma once

#include <array>

#include "controller/geometry/pose.h"

namespace dockyard::diver {

inline constexpr double kGravity_m_s2 = 9.81;

/// In the body's axes: x forward, y left, z up; the origin is the centre of mass. Moments and
/// products are diagonal. Numbers of a BlueROV2: Wu, "6-DoF modelling and control of a remotely
/// operated vehicle", Flinders University, 2018.
struct BodyModel {
  double mass_kg = 11.5, buoyancy_n = 114.8;
  Eigen::Vector3d p_RB{0.0, 0.0, 0.02};  // centre of buoyancy
  Eigen::Vector3d inertia_kg_m2{0.16, 0.16, 0.16};
  Eigen::Vector3d added_kg{5.5, 12.7, 14.57}, added_kg_m2{0.12, 0.12, 0.12};
  Eigen::Vector3d linear_n_s_m{4.03, 6.22, 5.18}, quadratic_n_s2_m2{18.18, 21.66, 36.99};
  Eigen::Vector3d linear_nm_s{0.07, 0.07, 0.07}, quadratic_nm_s2{1.55, 1.55, 1.55};
};

/// Left, right, lateral (to the left) and vertical (up).
inline constexpr int kThrusters = 4;
inline constexpr double kThrusterArm_m = 0.2;  // of left and right; assumed, 0.1-0.3
// Of a propeller of 76 mm: 50 N at 377 rad/s (T200 of Blue Robotics at 16 V, its data).
inline constexpr double kThrust_n_s2 = 3.5e-4;
inline constexpr double kMostSpeed_rad_s = 377.0;

/// Force and moment about the origin, in the body's axes.
struct Wrench {
  Eigen::Vector3d force_n{0, 0, 0}, moment_nm{0, 0, 0};
};
Wrench OfThrusters(const std::array<double, kThrusters>& speeds_rad_s);

/// A funnel that ends in a tube, along -x of the dock's frame D from its mouth at the origin. All
/// assumed: a cage takes the body's nose with some 0.1 m of play.
struct Cage {
  double mouth_radius_m = 0.6, tube_radius_m = 0.1;      // 0.4-1.0, 0.05-0.2
  double funnel_m = 0.5, length_m = 1.0;                 // 0.3-1.0, 0.7-2.0
  double stiffness_n_m = 2000.0, damping_n_s_m = 200.0;  // 500-5000, 50-500
  Eigen::Vector3d p_RN{0.25, 0.0, 0.0};                  // the nose; 0.2-0.4

  double RadiusAt(double depth_m) const;
  /// On the nose, in D: off the wall and off the end.
  Eigen::Vector3d Force(const Eigen::Vector3d& p_DN, const Eigen::Vector3d& v_DN_D) const;
};

struct BodyState {
  Pose3 X_DR;
  Eigen::Vector3d v_R{0, 0, 0};  // of the origin against the water [m/s], in the body's axes
  Eigen::Vector3d w_R{0, 0, 0};  // [rad/s]
};

/// The acceleration of the state under this wrench: Kirchhoff's equations with drag, weight and
/// buoyancy. In a uniform and steady current they hold against the water.
struct Acceleration {
  Eigen::Vector3d v_R, w_R;
};
Acceleration AccelerationOf(const BodyModel& body, const BodyState& state, const Wrench& wrench);

/// One step of time. current_D: speed of the water [m/s].
void Step(const BodyModel& body, const Wrench& wrench, const Eigen::Vector3d& current_D,
          double step_s, BodyState& state);

/// What the cage does to the body.
Wrench OfCage(const Cage& cage, const BodyState& state, const Eigen::Vector3d& current_D);

}  // namespace dockyard::diver
