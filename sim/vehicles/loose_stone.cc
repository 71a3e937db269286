#include "sim/vehicles/loose_stone.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/base/hash.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Points whose hull is a stone; assumed, 40-80.
constexpr int kPoints = 40;
// Zingg's ratios of width and height to length; assumed, 0.6-0.9 each.
constexpr double kWidth = 0.8, kHeight = 0.65;
// Noise of the radius, either way; assumed, 0.05-0.10.
constexpr double kRough = 0.08;

Matrix3d Turned(const Matrix3d& R, const Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return R;
  const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, turn / angle) * Eigen::Quaterniond(R));
  return q.normalized().toRotationMatrix();
}

}  // namespace

ConvexBody LooseStoneShape(double length_m, std::uint64_t key) {
  RandomStream random(key);
  std::vector<Vector3d> points;
  double low = 0.0, high = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double z = random.Uniform(-1.0, 1.0), angle = random.Uniform(-kPi, kPi);
    const double r = std::sqrt(1.0 - z * z), size = random.Uniform(1.0 - kRough, 1.0 + kRough);
    points.push_back(size *
                     Vector3d(r * std::cos(angle), kWidth * r * std::sin(angle), kHeight * z));
    low = std::min(low, points.back().x());
    high = std::max(high, points.back().x());
  }
  for (Vector3d& p : points) p *= length_m / (high - low);
  const Vector3d com = MassOf(HullOf(points), 1.0).p_com;
  for (Vector3d& p : points) p -= com;
  return HullOf(points);
}

Pose3 StandingAt(const ConvexBody& shape, const Eigen::Vector2d& p_G, double turn_rad,
                 double ground_m) {
  double low_m = shape.vertices.front().z();
  for (const Vector3d& p : shape.vertices) low_m = std::min(low_m, p.z());
  return {RotZ(turn_rad), {p_G.x(), p_G.y(), ground_m - low_m}};
}

LooseStone::LooseStone(const ConvexBody& shape, double density_kg_m3, const Pose3& X_GS) {
  const SolidMass solid = MassOf(shape, density_kg_m3);
  shape_S_ = Pose3{Matrix3d::Identity(), -solid.p_com} * shape;
  mass_kg_ = solid.mass_kg;
  inertia_S_ = solid.I_com;
  inverse_S_ = inertia_S_.inverse();
  motion_.X_GL = X_GS;
}

double LooseStone::KineticEnergy() const {
  return 0.5 * (mass_kg_ * motion_.v_GL_G.squaredNorm() + spin_G_.dot(InverseInertia() * spin_G_));
}

Matrix3d LooseStone::InverseInertia() const {
  return motion_.X_GL.R * inverse_S_ * motion_.X_GL.R.transpose();
}

void LooseStone::SetMotion(const Vector3d& v_G, const Vector3d& w_G) {
  motion_.v_GL_G = v_G;
  motion_.w_GL_G = w_G;
  spin_G_ = motion_.X_GL.R * (inertia_S_ * (motion_.X_GL.R.transpose() * w_G));
}

void LooseStone::AddImpulse(const Vector3d& impulse_G, const Vector3d& p_G) {
  motion_.v_GL_G += impulse_G / mass_kg_;
  spin_G_ += (p_G - motion_.X_GL.p).cross(impulse_G);
  motion_.w_GL_G = InverseInertia() * spin_G_;
}

void LooseStone::TakeWeight(const Vector3d& gravity_G, double step_s) {
  motion_.v_GL_G += step_s * gravity_G;
}

void LooseStone::Move(double step_s) {
  // Turns by the rate at the middle of the step.
  const Matrix3d& R = motion_.X_GL.R;
  const Matrix3d half = Turned(R, 0.5 * step_s * motion_.w_GL_G);
  const Vector3d rate = half * (inverse_S_ * (half.transpose() * spin_G_));
  motion_.X_GL.R = Turned(R, step_s * rate);
  motion_.X_GL.p += step_s * motion_.v_GL_G;
  motion_.w_GL_G = InverseInertia() * spin_G_;
}

std::uint64_t LooseStone::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (int i = 0; i < 9; ++i) hash = HashDouble(hash, motion_.X_GL.R(i));
  for (int i = 0; i < 3; ++i) {
    hash = HashDouble(hash, motion_.X_GL.p[i]);
    hash = HashDouble(hash, motion_.v_GL_G[i]);
    hash = HashDouble(hash, spin_G_[i]);
  }
  return hash;
}

}  // namespace dockyard
