// A block between two jaws: Coulomb's limit, energy, and the scoops' own statics.
#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/stone_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kBlock_m = 0.02, kLever_m = 1.0;

/// Two jaws that hang a metre below hinges along y on a base that does not move, the block between.
struct Vice {
  static TreeLink Jaw(double x_m) {
    TreeLink link;
    link.model.mass_kg = 0.2;
    link.model.p_LoCom_L = {0.0, 0.0, -kLever_m};
    link.model.I_LCom_L = 1e-4 * Eigen::Matrix3d::Identity();
    link.parent = 0;
    link.p_PL = {x_m, 0.0, kLever_m};
    return link;
  }
  static TreeLink Base() {
    TreeLink link;
    link.model.mass_kg = 1e6;
    link.model.I_LCom_L = 1e6 * Eigen::Matrix3d::Identity();
    return link;
  }
  static ConvexBody Plate(double side) {
    return Pose3::Translation(side * 0.001, 0.0, -kLever_m) * BoxBody({0.002, 0.1, 0.2});
  }
  explicit Vice(double friction = 0.6, double apart_m = kBlock_m, const Vector3d& v = {0, 0, 0},
                const Vector3d& w = {0, 0, 0})
      : ground(LevelGrid(-1.0, 2.0, 2.0, 0.1)), stones(world, {SoilNamed("loose_sand")}, 0.6) {
    world.Add(TreeBody({Base(), Jaw(-0.5 * apart_m), Jaw(0.5 * apart_m)}, {},
                       Pose3::Translation(0, 0, 5), {.base = TreeBase::kFixed}));
    stones.Add(MakeLooseStone(BoxBody(Vector3d::Constant(kBlock_m)), kStoneDensity_kg_m3,
                              Pose3::Translation(0, 0, 5)));
    TreeBody::Speeds start(6);
    start << v, w;
    world.body(stones.body(0)).AddSpeeds(start);
    const auto AddPart = [&](const BodyLink& at, const ConvexBody& body_L) {
      parts.Add({.at = at, .body_L = body_L, .material = MaterialOf(friction)});
    };
    AddPart({0, 1}, Plate(-1.0));
    AddPart({0, 2}, Plate(1.0));
    AddPart({stones.body(0), 0}, stones.shape_S(0));
  }
  const TreeBody& tree() const { return world.body(0); }
  const TreeBody& block() const { return world.body(stones.body(0)); }
  double weight_n() const { return block().link(0).model.mass_kg * kEarthGravity_m_s2; }

  /// press_n: of each jaw on the block. The jaws have no weight.
  void Step(double press_n, const Vector3d& gravity, const Vector3d& pull_G = {0, 0, 0}) {
    // About +y a jaw that hangs goes towards -x.
    world.body(0).AddJointTorque(1, -press_n * kLever_m);
    world.body(0).AddJointTorque(2, press_n * kLever_m);
    stones.AddForce(0, pull_G + block().link(0).model.mass_kg * gravity);
    parts.AddContacts();
    stones.AddSoilContacts(ground, step_s);
    world.Step(step_s);
    stones.Rest(ground, step_s);
  }
  /// How far the block goes in a time under its weight and a pull, once it is gripped.
  double Creep(double press_n, double time_s, const Vector3d& pull_G = {0, 0, 0}) {
    for (int i = 0; i < 500; ++i) Step(press_n, {0, 0, 0});
    const Vector3d from = block().motion(0).X_GL.p;
    const Vector3d gravity(0.0, 0.0, -kEarthGravity_m_s2);
    for (int i = 0; i < std::lround(time_s / step_s); ++i) Step(press_n, gravity, pull_G);
    return (block().motion(0).X_GL.p - from).norm();
  }

  HeightGrid ground;
  RigidWorld world{{0.0, 0.0, 0.0}};
  PartContacts parts{world};
  LooseStones stones;
  double step_s = 1e-3;
};

// It slips at m g = 2 mu N.
TEST(Grip, HoldsABlockBelowCoulombsLimitAndNotAbove) {
  for (const double friction : {0.2, 0.6}) {
    const double slips_n = Vice(friction).weight_n() / (2.0 * friction);
    EXPECT_LT(Vice(friction).Creep(slips_n / 0.95, 2.0), 0.05e-3) << friction;
    // What friction leaves of gravity: g (1 - 1 / 1.05).
    const double falls_m = 0.5 * kEarthGravity_m_s2 * (1.0 - 1.0 / 1.05) * 0.3 * 0.3;
    EXPECT_NEAR(Vice(friction).Creep(slips_n / 1.05, 0.3), falls_m, 0.1 * falls_m) << friction;
  }
}

TEST(Grip, GivesWayToAPullOfTwoNewtonsAtAFrictionOfATenthAndNotAtSixTenths) {
  const Vector3d pull_G(0.0, 2.0, 0.0);
  EXPECT_GT(Vice(0.1).Creep(8.0, 0.3, pull_G), 0.02);  // 2 x 0.1 x 8 N
  EXPECT_LT(Vice().Creep(8.0, 0.3, pull_G), 1e-4);
}

// Jaws that are driven open, shut and open give back no more than was put in.
TEST(Grip, GainsNoEnergyOverOpenCloseOpen) {
  Vice vice(0.6, 0.03);
  double work_j = 0.0;
  const auto Energy = [&] { return vice.tree().KineticEnergy() + vice.block().KineticEnergy(); };
  for (int i = 0; i < 3000; ++i) {
    const double press_n = i < 300 ? -0.05 : i < 1500 ? 2.0 : -0.5;
    vice.Step(press_n, {0, 0, 0});
    work_j +=
        press_n * kLever_m * vice.step_s * (vice.tree().rate_rad_s(2) - vice.tree().rate_rad_s(1));
    ASSERT_LE(Energy(), work_j + 1e-6) << i;
  }
}

// A block thrown between free jaws tumbles and bounces.
TEST(Grip, GainsNoEnergyFromBlows) {
  for (int run = 0; run < 5; ++run) {
    Vice vice(0.6, 0.05, {0.3 + 0.1 * run, 0.02 * run, 0.1}, {1.0 + run, 5.0 - run, 3.0});
    const double start_j = vice.block().KineticEnergy();
    for (int i = 0; i < 1000; ++i) {
      vice.Step(0.0, {0, 0, 0});
      ASSERT_LE(vice.tree().KineticEnergy() + vice.block().KineticEnergy(), 1.001 * start_j) << run;
    }
  }
}

TEST(Grip, CreepsNoFurtherWithStepsOfHalfTheLength) {
  const double slips_n = Vice().weight_n() / 1.2;
  Vice coarse, fine;
  fine.step_s = 0.5e-3;
  EXPECT_NEAR(coarse.Creep(1.3 * slips_n, 1.0), fine.Creep(1.3 * slips_n, 1.0), 1e-5);
}

}  // namespace
}  // namespace dockyard
