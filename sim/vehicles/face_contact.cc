#include "sim/vehicles/face_contact.h"

#include <algorithm>
#include <cmath>

#include "sim/base/hash.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr int kRimPoints = 12;

}  // namespace

FaceContact::FaceContact(const InstrumentModel& instrument, int link, double face_m)
    : instrument_(instrument), link_(link), p_L_middle_(face_m, 0.0, 0.0) {
  const auto Around = [&](double x_m, double radius_m, int count, double stiffness_n_per_m) {
    for (int i = 0; i < count; ++i) {
      // The first one is above the axis.
      const double angle = 2.0 * kPi * i / count;
      points_.push_back(
          {{x_m, radius_m * std::sin(angle), radius_m * std::cos(angle)}, stiffness_n_per_m});
    }
  };
  Around(face_m, instrument.switch_radius_m, kFaceSwitches, instrument.switch_n_per_m);
  Around(face_m - instrument.switch_out_m, instrument.radius_m, kRimPoints, instrument.rim_n_per_m);
  reach_m_ = std::hypot(instrument.radius_m, instrument.switch_out_m);
}

std::vector<FaceContact::Pressed> FaceContact::FindPressed(const StarBody& body_G,
                                                           const LinkMotion& motion) const {
  std::vector<Pressed> pressed;
  const Vector3d middle_G = motion.X_GL * p_L_middle_;
  if ((middle_G - body_G.centre).norm() > body_G.radius_m + reach_m_) return pressed;
  const Vector3d axis_G = motion.X_GL.R.col(0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector3d p_G = motion.X_GL * points_[i].p_L;
    const StarDepth at = DepthIn(body_G, p_G);
    if (at.depth_m <= 0.0) continue;
    pressed.push_back({i, at.depth_m, std::max(0.0, -at.normal.dot(axis_G)), p_G, at.normal});
  }
  return pressed;
}

// k u + c (u - u0) / h = sum of k_i (d_i - a_i u) a_i over the points that still press. With more
// give fewer press, so the set shrinks to the right one.
double FaceContact::Balance(const std::vector<Pressed>& pressed, double step_s) const {
  const double damper = instrument_.mast_ns_per_m / step_s;
  double give_m = 0.0;
  for (std::size_t tries = 0; tries <= pressed.size(); ++tries) {
    double stiffness = instrument_.mast_n_per_m + damper, load_n = damper * give_m_;
    for (const Pressed& at : pressed) {
      if (at.depth_m <= at.along * give_m) continue;
      const double k = points_[at.point].stiffness_n_per_m;
      stiffness += k * at.along * at.along;
      load_n += k * at.along * at.depth_m;
    }
    const double next_m = load_n / stiffness;
    if (next_m <= give_m) break;
    give_m = next_m;
  }
  return give_m;
}

void FaceContact::Step(const StarBody& body_G, double step_s, TreeBody& tree) {
  closed_ = {};
  force_n_ = 0.0;
  const LinkMotion& motion = tree.motion(link_);
  const std::vector<Pressed> pressed = FindPressed(body_G, motion);
  give_m_ = Balance(pressed, step_s);
  Vector3d centre_G = Vector3d::Zero(), normal_G = Vector3d::Zero();
  for (const Pressed& at : pressed) {
    const double press_n =
        points_[at.point].stiffness_n_per_m * std::max(0.0, at.depth_m - at.along * give_m_);
    tree.AddForce(link_, press_n * at.normal_G, at.p_G);
    force_n_ += press_n;
    centre_G += press_n * at.p_G;
    normal_G += press_n * at.normal_G;
    if (at.point < kFaceSwitches) closed_[at.point] = press_n >= instrument_.closes_n;
  }
  if (force_n_ <= 0.0) {
    bend_G_.setZero();
    return;
  }
  // The bristle bends within the surface, and slides where friction is used up.
  centre_G /= force_n_;
  normal_G.normalize();
  bend_G_ += step_s * motion.VelocityAt(centre_G);
  bend_G_ -= bend_G_.dot(normal_G) * normal_G;
  const double most_m = instrument_.friction * force_n_ / instrument_.mast_n_per_m;
  const double bend_m = bend_G_.norm();
  if (bend_m > most_m) bend_G_ *= most_m / bend_m;
  tree.AddForce(link_, -instrument_.mast_n_per_m * bend_G_, centre_G);
}

std::uint64_t FaceContact::StateHash(std::uint64_t seed) const {
  for (const double bend_m : bend_G_) seed = HashDouble(seed, bend_m);
  return HashDouble(seed, give_m_);
}

}  // namespace dockyard
