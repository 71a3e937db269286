// A block in a V-groove that is shaken below Coulomb's limit stays where it is, whatever the step.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double g = kEarthGravity_m_s2;
constexpr double kMass_kg = 4.0, kHalf_m = 0.1, kFriction = 0.2;
// Of a contact: that of Axel's cone.
constexpr double kStiffness_n_per_m = 2e5, kDamping_ns_per_m = 600.0;

/// A block whose two lower edges lie on the sides of a groove along x, at 45 deg. Its four corners
/// bear.
class Groove {
 public:
  explicit Groove(double step_s) : step_s_(step_s) {
    world_.Add(FreeBody(BoxModel(kMass_kg, {2.0 * kHalf_m, 0.1, 0.1}), {}));
  }
  /// For so long, under a force along the groove and a torque about the vertical and across it.
  template <class Load>
  void Play(double seconds, const Load& load) {
    for (long i = 0; i < std::lround(seconds / step_s_); ++i) {
      const double t = step_s_ * static_cast<double>(i);
      const auto [force_n, torque_nm] = load(t);
      world_.body(0).AddForce(0, force_n, pose().p);
      world_.body(0).AddTorque(0, torque_nm);
      AddCorners();
      world_.Step(step_s_);
      for (const WorldContact& contact : world_.contacts()) {
        least_n_ = std::min(least_n_, contact.impulse_G.dot(contact.normal_G) / step_s_);
      }
    }
  }
  const Pose3& pose() const { return world_.body(0).motion(0).X_GL; }
  double turn_rad() const { return std::atan2(pose().R(1, 0), pose().R(0, 0)); }
  double least_n() const { return least_n_; }
  /// From now on; what went before is not the shaking's.
  void Rub(double friction) {
    friction_ = friction;
    least_n_ = 1e9;
  }

 private:
  void AddCorners() {
    for (int i = 0; i < 4; ++i) {
      const double side = i & 1 ? 1.0 : -1.0;
      const Vector3d normal_G = Vector3d(0.0, -side, 1.0).normalized();
      const Vector3d p_G = pose() * Vector3d(i & 2 ? kHalf_m : -kHalf_m, 0.05 * side, -0.05);
      world_.AddContact({.a = {0, 0},
                         .pair = i,
                         .p_G = p_G,
                         .normal_G = normal_G,
                         .gap_m = normal_G.dot(p_G - Vector3d(0.0, 0.05 * side, -0.05)),
                         .material = {kStiffness_n_per_m, kDamping_ns_per_m, friction_},
                         .same_within_m = 5e-3});
    }
  }

  double step_s_, least_n_ = 1e9, friction_ = 0.0;
  RigidWorld world_{kDown};
};

struct Load {
  Vector3d force_n, torque_nm;
};
constexpr double kRate_rad_s = 2.0 * kPi * 3.0, kSeconds = 4.0;
Load None(double) { return {Vector3d::Zero(), Vector3d::Zero()}; }

/// How far it moved and turned, once it is shaken and left alone again. It settles without
/// friction, so that no corner is bent as the shaking begins.
struct Moved {
  double distance_m = 0.0, turn_rad = 0.0, least_n = 0.0;
};
Moved Shaken(double step_s, double force_n, double yaw_nm, double pitch_nm) {
  Groove groove(step_s);
  groove.Play(1.0, None);
  const Pose3 before = groove.pose();
  const double turn_rad = groove.turn_rad();
  groove.Rub(kFriction);
  groove.Play(kSeconds, [&](double t) -> Load {
    const double now = std::sin(kRate_rad_s * t), later = std::sin(1.7 * kRate_rad_s * t);
    return {{force_n * now, 0.0, 0.0}, {0.0, pitch_nm * later, yaw_nm * now}};
  });
  const double least_n = groove.least_n();
  groove.Play(1.0, None);
  return {(groove.pose().p - before.p).norm(), groove.turn_rad() - turn_rad, least_n};
}

// All corners together hold mu times their normal loads, m g sqrt 2.
const double kHeld_n = kFriction * kMass_kg * g * std::sqrt(2.0);

TEST(WorldShake, BelowCoulombsLimitNothingMoves) {
  for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
    const Moved moved = Shaken(step_s, 0.4 * kHeld_n, 0.1, 0.5);
    EXPECT_GT(moved.least_n, 1.0) << step_s;  // no corner lifts
    EXPECT_LT(moved.distance_m, 1e-8) << step_s;
    EXPECT_LT(std::abs(moved.turn_rad), 1e-8) << step_s;
  }
}

// A corner that lifts slides as it unloads, so the block creeps along. How far, the load
// decides, not the step.
TEST(WorldShake, CornersThatLiftCreepAlikeAtEveryStep) {
  const Moved fine = Shaken(0.25e-3, 0.5 * kHeld_n, 0.3, 4.3);
  EXPECT_GT(fine.distance_m, 1e-4);
  for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
    const Moved moved = Shaken(step_s, 0.5 * kHeld_n, 0.3, 4.3);
    EXPECT_EQ(moved.least_n, 0.0);
    EXPECT_NEAR(moved.distance_m, fine.distance_m, 0.1 * fine.distance_m) << step_s;
    EXPECT_NEAR(moved.turn_rad, fine.turn_rad, 1e-4) << step_s;
    RecordProperty("distance_um", std::to_string(1e6 * moved.distance_m));
  }
}

}  // namespace
}  // namespace dockyard
