#include "sim/vehicles/face_contact.h"

#include <cmath>

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr int kRimPoints = 12;

}  // namespace

FaceContact::FaceContact(const InstrumentModel& instrument, const BodyLink& can, double face_m)
    : can_(can), closes_n_(instrument.closes_n), p_L_middle_(face_m, 0.0, 0.0) {
  const auto Around = [&](double x_m, double radius_m, int count, double stiffness_n_per_m) {
    for (int i = 0; i < count; ++i) {
      // The first one is above the axis.
      const double angle = 2.0 * kPi * i / count;
      points_.push_back({{x_m, radius_m * std::sin(angle), radius_m * std::cos(angle)},
                         {stiffness_n_per_m, 0.0, instrument.friction, 0.0}});
    }
  };
  Around(face_m, instrument.switch_radius_m, kFaceSwitches, instrument.switch_n_per_m);
  Around(face_m - instrument.switch_out_m, instrument.radius_m, kRimPoints, instrument.rim_n_per_m);
  reach_m_ = std::hypot(instrument.radius_m, instrument.switch_out_m);
}

void FaceContact::AddContacts(const StarBody& body_G, RigidWorld& world) {
  pressed_.clear();
  const Pose3& X_GL = world.body(can_.body).motion(can_.link).X_GL;
  const Vector3d middle_G = X_GL * p_L_middle_;
  if ((middle_G - body_G.centre).norm() > body_G.radius_m + reach_m_) return;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector3d p_G = X_GL * points_[i].p_L;
    const StarDepth at = DepthIn(body_G, p_G);
    if (at.depth_m <= 0.0) continue;
    // The numbers of other pairs are not negative.
    const int number = world.AddContact({.a = can_,
                                         .pair = -1 - static_cast<std::int64_t>(i),
                                         .p_G = p_G,
                                         .normal_G = at.normal,
                                         .gap_m = -at.depth_m,
                                         .material = points_[i].material});
    pressed_.push_back({number, i});
  }
}

void FaceContact::TakeForces(const RigidWorld& world, double step_s) {
  closed_ = {};
  force_n_ = 0.0;
  for (const Pressed& at : pressed_) {
    const WorldContact& contact = world.contacts()[static_cast<std::size_t>(at.contact)];
    const double press_n = contact.normal_G.dot(contact.impulse_G) / step_s;
    force_n_ += press_n;
    if (at.point < kFaceSwitches) closed_[at.point] = press_n >= closes_n_;
  }
}

}  // namespace dockyard
