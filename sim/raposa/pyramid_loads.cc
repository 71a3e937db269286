#include "sim/raposa/pyramid_loads.h"

#include <algorithm>
#include <cmath>

#include "sim/base/hash.h"

namespace dockyard::raposa {
namespace {

// Point masses of the cable lie this far apart. Assumed, 0.1-0.3 m: 10-15 on 3 m.
constexpr double kCableSpacing_m = 0.2;
// Slack is let out before the run begins. Assumed, 0.3-1 m/s.
constexpr double kSlackRate_m_s = 0.5;
// A cable whose masses have all been slower than this for so long lies still: it is not stepped,
// and pulls as before, until its end moves by 0.1 um. Numerical: in a minute it would go 0.06 mm.
constexpr double kCalm_m_s = 1e-6, kCalm_s = 0.1, kStirred_m = 1e-7;
// The cable leaves the pyramid's back at this height above the ground. Assumed, 10-30 mm.
constexpr double kCableHeight_m = 0.015;

CableModel ModelOf(const TetherCableModel& cable) {
  return {.axial_stiffness_n = cable.axial_stiffness_n,
          .damping_ns_per_m = cable.damping_ns_per_m,
          .diameter_m = cable.diameter_m,
          .mass_kg_per_m = cable.mass_kg_per_m,
          .friction_on_ground = cable.friction_on_ground,
          .spacing_m = kCableSpacing_m};
}

}  // namespace

TreeBody MakePyramid(const PyramidModel& pyramid, const Pose3& X_GP) {
  return TreeBody({TreeLink{.model = pyramid.body}}, {}, X_GP);
}

PyramidLoads::PyramidLoads(const PyramidModel& pyramid, const Pose3& X_GP,
                           const Eigen::Vector3d& cable_to_G,
                           const std::vector<std::optional<SoilModel>>& soils)
    : pyramid_(pyramid),
      feet_(pyramid.p_P_soles.size()),
      cable_model_(ModelOf(pyramid.cable)),
      cable_(cable_model_),
      cable_to_G_(cable_to_G),
      slack_left_m_(pyramid.cable.slack_m) {
  const double share_kg = pyramid.body.mass_kg / static_cast<double>(feet_.size());
  GroundMaterial sole{.stiffness_n_per_m = pyramid.foot_stiffness_n_per_m,
                      .damping_ns_per_m = 2.0 * pyramid.foot_damping_ratio *
                                          std::sqrt(pyramid.foot_stiffness_n_per_m * share_kg),
                      .friction = pyramid.foot_friction};
  for (const std::optional<SoilModel>& soil : soils) {
    sole.plate = soil ? RoundPlate(*soil, pyramid.foot_diameter_m) : SinkingPlate{};
    soles_.push_back(sole);
  }
  // The last of the pieces is the one from the last mass to the pyramid.
  const Eigen::Vector3d way_G = CableEndInG(X_GP) - cable_to_G_;
  const int pieces = std::max(3, static_cast<int>(std::lround(way_G.norm() / kCableSpacing_m)));
  last_piece_m_ = way_G.norm() / pieces;
  cable_.LayOut(cable_to_G_, cable_to_G_ + (1.0 - 1.0 / pieces) * way_G, pieces - 1);
}

Eigen::Vector3d PyramidLoads::CableEndInG(const Pose3& X_GP) const {
  double rear_m = 0.0;
  for (const Eigen::Vector2d& p : pyramid_.p_P_soles) rear_m = std::min(rear_m, p.x());
  return X_GP * Eigen::Vector3d(rear_m, 0.0, kCableHeight_m - pyramid_.guide.height_m);
}

void PyramidLoads::AddTo(TreeBody& pyramid, const HeightGrid& ground,
                         const Eigen::Vector3d& gravity_G, double dt_s) {
  const LinkMotion& motion = pyramid.motion(0);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector2d& p = pyramid_.p_P_soles[i];
    const Eigen::Vector3d p_G =
        motion.X_GL * Eigen::Vector3d(p.x(), p.y(), -pyramid_.guide.height_m);
    const GroundMaterial& sole = soles_.at(ground.SoilAt(p_G));
    pyramid.AddForce(0, GroundForce(ground, sole, p_G, motion.VelocityAt(p_G), dt_s, feet_[i]),
                     p_G);
  }
  PullCable(pyramid, ground, gravity_G, dt_s);
}

void PyramidLoads::PullCable(TreeBody& pyramid, const HeightGrid& ground,
                             const Eigen::Vector3d& gravity_G, double dt_s) {
  const double fed_m = std::min(slack_left_m_, kSlackRate_m_s * dt_s);
  slack_left_m_ -= fed_m;
  const Eigen::Vector3d p_GE = CableEndInG(pyramid.motion(0).X_GL);
  const bool stirred = fed_m > 0.0 || (p_GE - p_GE_calm_).norm() > kStirred_m;
  if (calm_steps_ * dt_s >= kCalm_s && !stirred) return pyramid.AddForce(0, pull_G_, p_GE);
  const FixedCableEnd end(cable_model_, p_GE, last_piece_m_);
  cable_.Step({.step_s = dt_s,
               .gravity_G = gravity_G,
               .ground = &ground,
               .p_GF = cable_to_G_,
               .fed_m = fed_m,
               .end = &end,
               .end_rest_m = last_piece_m_});
  pull_G_ = -cable_.force_of_end_G();
  cable_pull_n_ = pull_G_.norm();
  pyramid.AddForce(0, pull_G_, p_GE);
  calm_steps_ = stirred || cable_.fastest_m_s() > kCalm_m_s ? 0 : calm_steps_ + 1;
  if (calm_steps_ == 0) p_GE_calm_ = p_GE;
}

std::vector<Eigen::Vector3d> PyramidLoads::CableLine(const Pose3& X_GP) const {
  std::vector<Eigen::Vector3d> line = cable_.Line(cable_to_G_, {});
  line.push_back(CableEndInG(X_GP));
  return line;
}

std::uint64_t PyramidLoads::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const GroundPoint& foot : feet_) hash = HashPoint(hash, foot);
  return cable_.StateHash(hash);
}

}  // namespace dockyard::raposa
