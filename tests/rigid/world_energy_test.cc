// Energy and momentum: what dampers take, and what bodies that meet keep.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class WorldEnergy : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldEnergy, testing::Values(0.5e-3, 1e-3, 2e-3));

double HeightEnergy(const TreeBody& tree) {
  double energy = 0.0;
  for (int i = 0; i < tree.link_count(); ++i) {
    const LinkModel& model = tree.link(i).model;
    energy += model.mass_kg * kEarthGravity_m_s2 * (tree.motion(i).X_GL * model.p_LoCom_L).z();
  }
  return energy;
}

// A chain that swings to rest: at any time the dampers' work is what it lost.
TEST_P(WorldEnergy, DampersTakeWhatASwingingChainLoses) {
  const double damping = 0.1;
  std::vector<TreeLink> links{Mount()};
  for (int i = 0; i < 4; ++i) {
    links.push_back(JointedLink(i, BoxModel(0.5, {0.02, 0.02, 0.25}, {0.0, 0.0, -0.125}),
                                {0.0, 0.0, i == 0 ? 0.0 : -0.25},
                                i % 2 == 0 ? Vector3d::UnitY() : Vector3d::UnitX()));
    links.back().damping_nms_per_rad = damping;
  }
  TreeBody chain(links, {}, {}, kMounted);
  const double hanging = HeightEnergy(chain);
  for (int i = 1; i <= 4; ++i) chain.SetAngle(i, 0.8);
  RigidWorld world(kDown);
  world.Add(std::move(chain));
  const double start = HeightEnergy(world.body(0)) - hanging;
  double worked = 0.0, least = start, worst = 0.0, gained = 0.0;
  for (long i = 0; i < StepsIn(10.0); ++i) {
    const double height = HeightEnergy(world.body(0)) - hanging;
    const TreeBody::Speeds before = world.body(0).speeds();
    world.Step(step_s());
    const TreeBody& at = world.body(0);
    if (i == 0) continue;  // speeds belong to the middle of steps
    const TreeBody::Speeds middle = 0.5 * (before + at.speeds());
    const double energy = height + 0.5 * middle.dot(at.MassMatrix() * middle);
    worst = std::max(worst, std::abs(energy + worked - start));
    gained = std::max(gained, energy - least);
    least = std::min(least, energy);
    worked += step_s() * damping * at.speeds().squaredNorm();
  }
  RecordProperty("balance_share", std::to_string(worst / start));
  RecordProperty("gained_share_1e9", std::to_string(1e9 * gained / start));
  RecordProperty("left_share", std::to_string(least / start));
  EXPECT_LT(worst, 0.01 * start);
  EXPECT_LT(gained, 2e-5 * start);
}

/// A box over the ground, with the energy of half a step before: speeds belong to that time.
class BouncingBox {
 public:
  explicit BouncingBox(double step_s) : step_s_(step_s), world_(kDown) {
    TreeBody box =
        FreeBody(BoxModel(2.0, kSize_m), {ToRotation({0.4, 0.3, 0.2}), Vector3d(0.0, 0.0, 0.5)});
    SetSpeeds(box, {0.5, 0.0, 0.0, 3.0, 4.0, 2.0});
    world_.Add(std::move(box));
  }
  void Step() {
    for (int i = 0; i < 8; ++i) {
      const Vector3d p_G = Corner(i);
      world_.AddContact(
          {.a = {0, 0}, .pair = i, .p_G = p_G, .gap_m = p_G.z(), .material = kBounce});
    }
    world_.Step(step_s_);
  }
  /// Of motion, height and the contacts' springs.
  double Energy() const {
    const TreeBody& box = world_.body(0);
    const LinkMotion& motion = box.motion(0);
    double energy =
        box.KineticEnergy() + HeightEnergy(box) -
        0.5 * step_s_ * box.link(0).model.mass_kg * kEarthGravity_m_s2 * motion.v_GL_G.z();
    for (int i = 0; i < 8; ++i) {
      const Vector3d p_G = Corner(i);
      const double deep_m = std::max(0.0, 0.5 * step_s_ * motion.VelocityAt(p_G).z() - p_G.z());
      energy += 0.5 * kBounce.stiffness_n_per_m * deep_m * deep_m;
    }
    for (const WorldContact& contact : world_.contacts()) {
      energy += 0.5 * kBounce.stiffness_n_per_m * contact.bend_G.squaredNorm();
    }
    return energy;
  }

 private:
  static constexpr ContactMaterial kBounce{1e5, 50.0, 0.4, 0.0};
  inline static const Vector3d kSize_m{0.2, 0.15, 0.1};
  Vector3d Corner(int i) const {
    const Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    return world_.body(0).motion(0).X_GL * corner.cwiseProduct(kSize_m);
  }

  double step_s_;
  RigidWorld world_;
};

// Its contacts' dampers and friction take energy until it lies.
TEST_P(WorldEnergy, BoxThatFallsAndBouncesNeverGainsEnergy) {
  BouncingBox box(step_s());
  box.Step();
  const double start = box.Energy();
  double lowest = start, gained = 0.0;
  for (long i = 0; i < StepsIn(3.0); ++i) {
    box.Step();
    const double energy = box.Energy();
    gained = std::max(gained, energy - lowest);
    lowest = std::min(lowest, energy);
  }
  RecordProperty("gained_share_1e9", std::to_string(1e9 * gained / start));
  RecordProperty("left_share", std::to_string(lowest / start));
  EXPECT_LT(lowest, 0.2 * start);
  EXPECT_LT(gained, 1e-8 * start);
}

/// Momentum, and its moment about the origin.
struct Momentum {
  Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();
};
Momentum MomentumOf(const RigidWorld& world, int bodies) {
  Momentum sum;
  for (int b = 0; b < bodies; ++b) {
    const TreeBody& tree = world.body(b);
    for (int i = 0; i < tree.link_count(); ++i) {
      const LinkModel& model = tree.link(i).model;
      const LinkMotion& at = tree.motion(i);
      const Vector3d com_G = at.X_GL * model.p_LoCom_L;
      const Vector3d linear = model.mass_kg * at.VelocityAt(com_G);
      sum.linear += linear;
      sum.angular +=
          com_G.cross(linear) + at.X_GL.R * (model.I_LCom_L * (at.X_GL.R.transpose() * at.w_GL_G));
    }
  }
  return sum;
}

// Two arms of two links on free bases. The blow gives the one what it takes from the other; between
// blows a tree's moment of momentum drifts with the step, as its links turn.
TEST_P(WorldEnergy, BlowOfTwoFreeTreesKeepsMomentumAndItsMoment) {
  RigidWorld world({0, 0, 0});
  for (const double side : {-1.0, 1.0}) {
    TreeBody arm({BaseLink(BoxModel(2.0, {0.2, 0.1, 0.1})),
                  JointedLink(0, BoxModel(0.5, {0.3, 0.05, 0.05}, {-0.15 * side, 0.0, 0.0}),
                              {-0.1 * side, 0.0, 0.0}, Vector3d::UnitZ())},
                 {}, Pose3::Translation(0.43 * side, 5e-3 * side, 0.0));
    SetSpeeds(arm, {-side, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0});
    world.Add(std::move(arm));
  }
  const auto Tip = [&](int arm) -> Vector3d {
    return world.body(arm).motion(1).X_GL * Vector3d(arm == 0 ? 0.3 : -0.3, 0.0, 0.0);
  };
  const Momentum start = MomentumOf(world, 2);
  double pressed_ns = 0.0, off_ns = 0.0, off_nms = 0.0;
  for (long i = 0; i < StepsIn(0.05); ++i) {
    // Balls of 1 cm on the tips.
    const Vector3d apart_G = Tip(1) - Tip(0);
    world.AddContact({.a = {1, 1},
                      .b = {0, 1},
                      .p_G = 0.5 * (Tip(0) + Tip(1)),
                      .normal_G = apart_G.normalized(),
                      .gap_m = apart_G.norm() - 0.02,
                      .material = {1e5, 50.0, 0.4, 0.0}});
    world.TakeLoads(step_s());
    const Momentum loaded = MomentumOf(world, 2);
    world.Resist(step_s());
    const Momentum after = MomentumOf(world, 2);
    off_ns = std::max(off_ns, (after.linear - loaded.linear).norm());
    off_nms = std::max(off_nms, (after.angular - loaded.angular).norm());
    world.Move(step_s());
    pressed_ns += world.contacts()[0].impulse_G.norm();
  }
  const Momentum end = MomentumOf(world, 2);
  const double drift_nms = (end.angular - start.angular).norm();
  RecordProperty("drift_unms", std::to_string(1e6 * drift_nms));
  EXPECT_GT(pressed_ns, 0.1);
  EXPECT_LT(off_ns, 1e-14);
  EXPECT_LT(off_nms, 1e-14);
  EXPECT_LT((end.linear - start.linear).norm(), 1e-12);
  EXPECT_LT(drift_nms, 1e-4);
}

}  // namespace
}  // namespace dockyard
