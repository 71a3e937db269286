#include "sim/physics/face_contact.h"

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
  const auto Around = [&](double x_m, double radius_m, int count) {
    for (int i = 0; i < count; ++i) {
      // The first one is above the axis.
      const double angle = 2.0 * kPi * i / count;
      points_.push_back({{x_m, radius_m * std::sin(angle), radius_m * std::cos(angle)}, {0, 0, 0}});
    }
  };
  Around(face_m, instrument.switch_radius_m, kFaceSwitches);
  Around(face_m - instrument.switch_out_m, instrument.radius_m, kRimPoints);
  reach_m_ = std::hypot(instrument.radius_m, instrument.switch_out_m);
}

void FaceContact::Step(const StarBody& body_G, double step_s, TreeBody& tree) {
  closed_ = {};
  force_n_ = 0.0;
  const LinkMotion& motion = tree.motion(link_);
  const Vector3d middle_G = motion.X_GL * p_L_middle_;
  if ((middle_G - body_G.centre).norm() > body_G.radius_m + reach_m_) {
    for (Point& point : points_) point.bend_G.setZero();
    return;
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& point = points_[i];
    const Vector3d p_G = motion.X_GL * point.p_L;
    const StarDepth at = DepthIn(body_G, p_G);
    if (at.depth_m <= 0.0) {
      point.bend_G.setZero();
      continue;
    }
    const Vector3d v_G = motion.VelocityAt(p_G);
    const double in_m_s = -v_G.dot(at.normal);
    const double press_n = std::max(
        0.0, instrument_.stiffness_n_per_m * at.depth_m + instrument_.damping_ns_per_m * in_m_s);
    // The bristle bends within the face, and slides where friction is used up.
    point.bend_G += step_s * (v_G + in_m_s * at.normal);
    point.bend_G -= point.bend_G.dot(at.normal) * at.normal;
    const double most_m = instrument_.friction * press_n / instrument_.stiffness_n_per_m;
    const double bend_m = point.bend_G.norm();
    if (bend_m > most_m) point.bend_G *= most_m / bend_m;
    tree.AddForce(link_, press_n * at.normal - instrument_.stiffness_n_per_m * point.bend_G, p_G);
    force_n_ += press_n;
    if (i < kFaceSwitches) closed_[i] = press_n >= instrument_.closes_n;
  }
}

std::uint64_t FaceContact::StateHash(std::uint64_t seed) const {
  for (const Point& point : points_) {
    for (const double bend_m : point.bend_G) seed = HashDouble(seed, bend_m);
  }
  return seed;
}

}  // namespace dockyard
