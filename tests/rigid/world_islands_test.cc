// Bodies that do not touch, and bodies that sleep.
#include <gtest/gtest.h>

#include <vector>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kStep_s = 1e-3, kSide_m = 0.1;
constexpr ContactMaterial kMaterial{1e5, 200.0, 0.5, 0.0};

int AddBox(RigidWorld& world, const Vector3d& p_G) {
  return world.Add(FreeBody(BoxModel(1.0, Vector3d::Constant(kSide_m)), {RotZ(0.2), p_G}));
}

/// The box's lower corners on the ground at height 0.
void AddCorners(RigidWorld& world, int box) {
  for (int i = 0; i < 4; ++i) {
    const Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, -0.5);
    const Vector3d p_G = world.body(box).motion(0).X_GL * (kSide_m * corner);
    world.AddContact(
        {.a = {box, 0}, .pair = i, .p_G = p_G, .gap_m = p_G.z(), .material = kMaterial});
  }
}

// A box that slides takes other sweeps than one that falls from a height.
TEST(WorldIslands, BodyMovesByTheSameBitsWhateverMovesElsewhere) {
  const auto Slide = [](bool with_other) {
    RigidWorld world(kDown);
    const int slider = AddBox(world, {0.0, 0.0, 0.5 * kSide_m});
    if (with_other) AddBox(world, {5.0, 0.0, 2.0 * kSide_m});
    SetSpeeds(world.body(slider), {1.0, 0.3, 0.0, 0.0, 0.0, 2.0});
    for (int i = 0; i < 300; ++i) {
      AddCorners(world, slider);
      if (with_other) AddCorners(world, 1);
      world.Step(kStep_s);
    }
    return world.body(slider).StateHash(1);
  };
  EXPECT_EQ(Slide(true), Slide(false));
}

TEST(WorldSleep, SleeperStaysAndBearsWhatLiesOnItUntilItIsWoken) {
  RigidWorld world(kDown);
  const int below = AddBox(world, {0.0, 0.0, 0.5 * kSide_m});
  const int above = AddBox(world, {0.0, 0.0, 1.5 * kSide_m});
  const auto Step = [&](bool with_ground) {
    if (with_ground) AddCorners(world, below);
    for (int i = 0; i < 4; ++i) {
      const Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, -0.5);
      const Vector3d p_G = world.body(above).motion(0).X_GL * (kSide_m * corner);
      const double top_m = world.body(below).motion(0).X_GL.p.z() + 0.5 * kSide_m;
      world.AddContact({.a = {above, 0},
                        .b = {below, 0},
                        .pair = i,
                        .p_G = p_G,
                        .gap_m = p_G.z() - top_m,
                        .material = kMaterial});
    }
    world.Step(kStep_s);
  };
  for (int i = 0; i < 1000; ++i) Step(true);
  const Pose3 rests = world.body(below).motion(0).X_GL;
  world.SetAsleep(below, true);
  for (int i = 0; i < 100; ++i) Step(false);
  EXPECT_EQ(world.body(below).motion(0).X_GL.p, rests.p);
  double borne_n = 0.0, under_n = 0.0;
  for (const WorldContact& contact : world.contacts()) {
    (contact.a.body == above ? borne_n : under_n) += contact.impulse_G.z() / kStep_s;
  }
  EXPECT_NEAR(borne_n, kEarthGravity_m_s2, 1e-6);
  EXPECT_NEAR(under_n, 2.0 * kEarthGravity_m_s2, 1e-6);  // as it was before

  // Awake it goes on from there, without a jump.
  world.SetAsleep(below, false);
  for (int i = 0; i < 100; ++i) Step(true);
  EXPECT_LT((world.body(below).motion(0).X_GL.p - rests.p).norm(), 1e-9);
}

// Two hinges on one base, the one driven against the other by a torque.
TEST(WorldJoints, DifferenceOfTwoJointsRestsOnItsStop) {
  const double torque_nm = 0.3, limit_rad = 0.4;
  RigidWorld world({0.0, 0.0, 0.0});
  const LinkModel model = BoxModel(0.2, {0.1, 0.02, 0.02}, {0.05, 0.0, 0.0});
  const int body = world.Add(TreeBody({Mount(), JointedLink(0, model, {0, 0, 0}, {0, 1, 0}),
                                       JointedLink(0, model, {0, 0, 0}, {0, 1, 0})},
                                      {}, {}, kMounted));
  world.LimitBetween({body, 1}, 2,
                     {.low_rad = -limit_rad,
                      .high_rad = limit_rad,
                      .stop_nm_per_rad = 600.0,
                      .stop_nms_per_rad = 0.9});
  for (int i = 0; i < 3000; ++i) {
    world.body(body).AddJointTorque(1, torque_nm);
    world.body(body).AddJointTorque(2, -torque_nm);
    world.Step(kStep_s);
  }
  EXPECT_NEAR(world.body(body).angle_rad(1) - world.body(body).angle_rad(2),
              limit_rad + torque_nm / 600.0, 1e-9);
}

}  // namespace
}  // namespace dockyard
