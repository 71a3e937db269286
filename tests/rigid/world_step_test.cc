// A wheel over a step: the force that pulls it up, and the speed that carries it up.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rigid/world_scenes.h"
#include "sim/rigid/body_contact.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class WorldStep : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldStep, testing::Values(0.5e-3, 1e-3, 2e-3));

/// A disc of even mass on the ground, before a block whose edge is at x 0. Places, of the wheel.
class WheelAtStep {
 public:
  static constexpr double kRadius_m = 0.15, kMass_kg = 4.0;
  WheelAtStep(double height_m, double before_m, double speed_m_s, const ContactMaterial& material)
      : world_(kDown), material_(material) {
    std::vector<Vector3d> corners;
    for (int i = 0; i < 8; ++i) {
      corners.emplace_back(i & 1 ? 1.0 : 0.0, i & 2 ? 0.3 : -0.3, i & 4 ? height_m : 0.0);
    }
    block_ = HullOf(corners);
    const double moment = 0.5 * kMass_kg * kRadius_m * kRadius_m;
    TreeBody wheel =
        FreeBody(TurningModel(kMass_kg, moment, 0.5 * moment),
                 {RotX(0.5 * kPi), Vector3d(-Ahead(height_m) - before_m, 0.0, kRadius_m)});
    SetSpeeds(wheel, {speed_m_s, 0.0, 0.0, 0.0, speed_m_s / kRadius_m, 0.0});
    world_.Add(std::move(wheel));
  }
  /// From the edge back to the axle of a wheel that touches it and the ground.
  static double Ahead(double height_m) {
    return std::sqrt(height_m * (2.0 * kRadius_m - height_m));
  }
  void Step(double step_s, double pull_n) {
    const Pose3 X_GL = world_.body(0).motion(0).X_GL;
    std::vector<BodyContact> found;
    AddCylinderContacts(block_, {X_GL.p, X_GL.R.col(2), kRadius_m, 0.05}, 0, found);
    for (const BodyContact& at : found) {
      world_.AddContact({.a = {0, 0},
                         .pair = at.feature,
                         .p_G = at.p,
                         .normal_G = at.normal,
                         .gap_m = -at.depth_m,
                         .share = at.share,
                         .material = material_});
    }
    for (const double side_m : {-0.05, 0.05}) {
      const Vector3d p_G = X_GL.p + side_m * X_GL.R.col(2) - kRadius_m * Vector3d::UnitZ();
      world_.AddContact({.a = {0, 0},
                         .pair = side_m < 0.0 ? -1 : -2,
                         .p_G = p_G,
                         .gap_m = p_G.z(),
                         .material = material_});
    }
    world_.body(0).AddForce(0, pull_n * Vector3d::UnitX(), X_GL.p);
    world_.Step(step_s);
    highest_m_ = std::max(highest_m_, world_.body(0).motion(0).X_GL.p.z() - kRadius_m);
  }
  /// Of its axle, over the place on the ground.
  double highest_m() const { return highest_m_; }

 private:
  RigidWorld world_;
  ContactMaterial material_;
  ConvexBody block_;
  double highest_m_ = 0.0;
};

// Pulled level at its axle it leaves the ground at W sqrt(r^2 - (r - h)^2) / (r - h).
TEST_P(WorldStep, WheelClimbsByItsThresholdForce) {
  const double height_m = 0.05, weight_n = WheelAtStep::kMass_kg * kEarthGravity_m_s2;
  const double least_n =
      weight_n * WheelAtStep::Ahead(height_m) / (WheelAtStep::kRadius_m - height_m);
  for (const double share : {0.99, 1.01}) {
    WheelAtStep wheel(height_m, 0.0, 0.0, {2e5, 500.0, 1.0, 0.0});
    // Pulled up to the force within the first second.
    for (long i = 0; i < StepsIn(3.0); ++i) {
      wheel.Step(step_s(), share * std::min(1.0, step_s() * static_cast<double>(i)) * least_n);
    }
    EXPECT_EQ(wheel.highest_m() > 0.03, share > 1.0) << share << " " << wheel.highest_m();
  }
}

// The blow at the edge keeps the moment of momentum about it: of 3/2 v / r the wheel keeps
// (r - h) / r + 1/2. The rest must lift it by h.
TEST_P(WorldStep, WheelRollsOverAtTheSpeedThatTheBlowLeavesEnoughOf) {
  const double height_m = 0.03, radius_m = WheelAtStep::kRadius_m;
  const double kept = ((radius_m - height_m) / radius_m + 0.5) / 1.5;
  const double least_m_s = std::sqrt(2.0 * kEarthGravity_m_s2 * height_m / 1.5) / kept;
  for (const double share : {0.99, 1.01}) {
    WheelAtStep wheel(height_m, 0.05, share * least_m_s, {1e6, 4e3, 1.0, 0.0});
    for (long i = 0; i < StepsIn(1.5); ++i) wheel.Step(step_s(), 0.0);
    EXPECT_EQ(wheel.highest_m() > height_m - 1e-4, share > 1.0)
        << share << " " << wheel.highest_m();
  }
}

}  // namespace
}  // namespace dockyard
