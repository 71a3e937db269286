#include "toy_underwater/diver_body.h"

#include <algorithm>
#include <cmath>

namespace dockyard::diver {
namespace {

Eigen::Vector3d Drag(const Eigen::Vector3d& linear, const Eigen::Vector3d& quadratic,
                     const Eigen::Vector3d& speed) {
  return -(linear + quadratic.cwiseProduct(speed.cwiseAbs())).cwiseProduct(speed);
}

}  // namespace

Wrench OfThrusters(const std::array<double, kThrusters>& speeds_rad_s) {
  const auto thrust_n = [&](int i) {
    const double speed = speeds_rad_s[static_cast<std::size_t>(i)];
    return kThrust_n_s2 * speed * std::abs(speed);
  };
  return {{thrust_n(0) + thrust_n(1), thrust_n(2), thrust_n(3)},
          {0.0, 0.0, kThrusterArm_m * (thrust_n(1) - thrust_n(0))}};
}

double Cage::RadiusAt(double depth_m) const {
  const double share = std::clamp(depth_m / funnel_m, 0.0, 1.0);
  return mouth_radius_m + share * (tube_radius_m - mouth_radius_m);
}

Eigen::Vector3d Cage::Force(const Eigen::Vector3d& p_DN, const Eigen::Vector3d& v_DN_D) const {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  const double depth_m = -p_DN.x();
  if (depth_m <= 0.0) return force;
  // A spring only pushes.
  const auto push = [&](const Eigen::Vector3d& away, double pressed_m) {
    const double push_n = stiffness_n_m * pressed_m - damping_n_s_m * away.dot(v_DN_D);
    if (pressed_m > 0.0 && push_n > 0.0) force += push_n * away;
  };
  push(Eigen::Vector3d::UnitX(), depth_m - length_m);
  const Eigen::Vector3d off(0.0, p_DN.y(), p_DN.z());
  const double slope = depth_m < funnel_m ? (mouth_radius_m - tube_radius_m) / funnel_m : 0.0;
  if (off.norm() > 0.0) {
    // Square to the funnel's wall.
    const Eigen::Vector3d away = (slope * Eigen::Vector3d::UnitX() - off.normalized()).normalized();
    push(away, (off.norm() - RadiusAt(depth_m)) / std::hypot(1.0, slope));
  }
  return force;
}

Acceleration AccelerationOf(const BodyModel& body, const BodyState& state, const Wrench& wrench) {
  const Eigen::Vector3d mass = Eigen::Vector3d::Constant(body.mass_kg) + body.added_kg;
  const Eigen::Vector3d inertia = body.inertia_kg_m2 + body.added_kg_m2;
  const Eigen::Vector3d &v = state.v_R, &w = state.w_R;
  const Eigen::Vector3d up = state.X_DR.R.transpose() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d momentum = mass.cwiseProduct(v), spin = inertia.cwiseProduct(w);
  const Eigen::Vector3d force = wrench.force_n +
                                Drag(body.linear_n_s_m, body.quadratic_n_s2_m2, v) +
                                (body.buoyancy_n - kGravity_m_s2 * body.mass_kg) * up;
  const Eigen::Vector3d moment = wrench.moment_nm +
                                 Drag(body.linear_nm_s, body.quadratic_nm_s2, w) +
                                 body.p_RB.cross(body.buoyancy_n * up);
  return {(force - w.cross(momentum)).cwiseQuotient(mass),
          (moment - w.cross(spin) - v.cross(momentum)).cwiseQuotient(inertia)};
}

// The middle of the step for the rates, so that a free body keeps its energy to second order.
void Step(const BodyModel& body, const Wrench& wrench, const Eigen::Vector3d& current_D,
          double step_s, BodyState& state) {
  const auto moved = [&](const BodyState& at, double seconds) {
    BodyState next = at;
    next.X_DR.p += seconds * (at.X_DR.R * at.v_R + current_D);
    const double turn_rad = seconds * at.w_R.norm();
    if (turn_rad != 0.0) {
      next.X_DR.R = at.X_DR.R * Eigen::AngleAxisd(turn_rad, at.w_R.normalized());
    }
    return next;
  };
  const auto pushed = [&](const BodyState& at, double seconds) {
    const Acceleration rate = AccelerationOf(body, at, wrench);
    BodyState next = state;
    next.v_R += seconds * rate.v_R;
    next.w_R += seconds * rate.w_R;
    return next;
  };
  const BodyState half = moved(pushed(state, 0.5 * step_s), 0.5 * step_s);
  BodyState end = pushed(half, step_s);
  BodyState path = state;
  path.w_R = half.w_R;
  end.X_DR.R = moved(path, step_s).X_DR.R;
  end.X_DR.p = state.X_DR.p + step_s * (half.X_DR.R * half.v_R + current_D);
  state = end;
}

Wrench OfCage(const Cage& cage, const BodyState& state, const Eigen::Vector3d& current_D) {
  const Eigen::Matrix3d& R = state.X_DR.R;
  const Eigen::Vector3d v_DN_D = R * (state.v_R + state.w_R.cross(cage.p_RN)) + current_D;
  const Eigen::Vector3d force = R.transpose() * cage.Force(state.X_DR * cage.p_RN, v_DN_D);
  return {force, cage.p_RN.cross(force)};
}

}  // namespace dockyard::diver
