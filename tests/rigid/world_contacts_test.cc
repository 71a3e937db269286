// Contacts of a world's bodies with each other and with what never moves, against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class WorldContacts : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldContacts, testing::Values(0.5e-3, 1e-3, 2e-3));

constexpr double g = kEarthGravity_m_s2;

/// The lower corners of a box on the level top of what is below: another box or the ground.
void AddCorners(RigidWorld& world, int box, const Vector3d& size_m, int below, double top_m,
                const ContactMaterial& material) {
  const Pose3 top = below < 0 ? Pose3{} : world.body(below).motion(0).X_GL;
  const Vector3d normal_G = top.R.col(2);
  for (int i = 0; i < 4; ++i) {
    const Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, -0.5);
    const Vector3d p_G = world.body(box).motion(0).X_GL * corner.cwiseProduct(size_m);
    world.AddContact({.a = {box, 0},
                      .b = {below, 0},
                      .pair = i,
                      .p_G = p_G,
                      .normal_G = normal_G,
                      .gap_m = normal_G.dot(p_G - top * Vector3d(0.0, 0.0, top_m)),
                      .material = material});
  }
}

TEST_P(WorldContacts, StackOfBoxesRestsAndBearsItsWeight) {
  const Vector3d size_m(0.1, 0.1, 0.1);
  const ContactMaterial material{1e5, 200.0, 0.5, 0.0};
  const int boxes = 5;
  RigidWorld world(kDown);
  for (int i = 0; i < boxes; ++i) {
    // Each a little turned and aside.
    world.Add(FreeBody(BoxModel(1.0, size_m),
                       {RotZ(0.1 * i), Vector3d(2e-3 * (i % 2), 0.0, 0.05 + 0.1 * i)}));
  }
  const auto Step = [&] {
    for (int i = 0; i < boxes; ++i) {
      AddCorners(world, i, size_m, i - 1, i == 0 ? 0.0 : 0.05, material);
    }
    world.Step(step_s());
  };
  for (long i = 0; i < StepsIn(2.0); ++i) Step();
  std::vector<Pose3> before;
  for (int i = 0; i < boxes; ++i) before.push_back(world.body(i).motion(0).X_GL);
  for (long i = 0; i < StepsIn(2.0); ++i) Step();
  double creep_m = 0.0;
  for (int i = 0; i < boxes; ++i) {
    double force_n = 0.0;
    for (const WorldContact& contact : world.contacts()) {
      if (contact.a.body == i) force_n += contact.impulse_G.z() / step_s();
    }
    EXPECT_NEAR(force_n, (boxes - i) * g, 1e-4 * g);
    const Vector3d moved = world.body(i).motion(0).X_GL.p - before[static_cast<std::size_t>(i)].p;
    creep_m = std::max(creep_m, moved.norm());
  }
  EXPECT_LT(creep_m, 1e-6);
  RecordProperty("creep_nm", std::to_string(1e9 * creep_m));
  RecordProperty("sweeps", world.sweeps());
  // Each contact yields by its share of the weight above.
  double height_m = 0.05, off_m = 0.0;
  for (int i = 0; i < boxes; ++i, height_m += 0.1) {
    height_m -= (boxes - i) * g / (4.0 * 1e5);
    off_m = std::max(off_m, std::abs(world.body(i).motion(0).X_GL.p.z() - height_m));
  }
  RecordProperty("height_off_nm", std::to_string(1e9 * off_m));
  EXPECT_LT(off_m, 1e-6);
}

// Half its width over half its height.
TEST_P(WorldContacts, BoxTipsOverOnARampAtItsAngle) {
  const Vector3d size_m(0.2, 0.2, 0.4);
  for (const double share : {0.99, 1.01}) {
    RigidWorld world(kDown);
    world.Add(FreeBody(BoxModel(3.0, size_m), Pose3::Translation(0.0, 0.0, 0.2)));
    for (long i = 0; i < StepsIn(4.0); ++i) {
      const double slope = 0.5 * share * std::min(1.0, step_s() * static_cast<double>(i));
      world.SetGravity(g * Vector3d(slope, 0.0, -1.0).normalized());
      AddCorners(world, 0, size_m, -1, 0.0, {1e6, 2e3, 1.0, 0.0});
      world.Step(step_s());
    }
    EXPECT_EQ(world.body(0).motion(0).X_GL.R(2, 2) < 0.9, share > 1.0) << share;
  }
}

// Where friction holds less than the slope at which it tips, it slides, at g (sin - mu cos).
TEST_P(WorldContacts, BoxSlidesOnARampBeforeItTips) {
  const double friction = 0.3, slope_rad = std::atan(0.45), seconds = 1.0;  // 0.5: it would tip
  const Vector3d size_m(0.2, 0.2, 0.4);
  RigidWorld world(kDown);
  world.Add(FreeBody(BoxModel(3.0, size_m), Pose3::Translation(0.0, 0.0, 0.2)));
  const auto Slide = [&](double for_s) {
    for (long i = 0; i < StepsIn(for_s); ++i) {
      AddCorners(world, 0, size_m, -1, 0.0, {1e6, 2e3, friction, 0.0});
      world.Step(step_s());
    }
  };
  Slide(1.0);  // settles
  world.SetGravity(g * Vector3d(std::sin(slope_rad), 0.0, -std::cos(slope_rad)));
  Slide(seconds);
  const double wanted_m_s = seconds * g * (std::sin(slope_rad) - friction * std::cos(slope_rad));
  const LinkMotion& box = world.body(0).motion(0);
  RecordProperty("off_share", std::to_string(box.v_GL_G.x() / wanted_m_s - 1.0));
  EXPECT_NEAR(box.v_GL_G.x(), wanted_m_s, 0.01 * wanted_m_s);
  EXPECT_GT(box.X_GL.R(2, 2), 0.9999);
}

// Two jaws of one tree, pressed on each other by their slides.
TEST_P(WorldContacts, LinksOfOneTreePressOnEachOther) {
  const Vector3d x = Vector3d::UnitX();
  RigidWorld world(kDown);
  world.Add(TreeBody(
      {Mount(), JointedLink(0, BoxModel(0.3, {0.1, 0.1, 0.1}), {-0.05, 0, 0}, x, JointKind::kSlide),
       JointedLink(0, BoxModel(0.6, {0.1, 0.1, 0.1}), {0.05, 0, 0}, x, JointKind::kSlide)},
      {}, {}, kMounted));
  for (long i = 0; i < StepsIn(1.0); ++i) {
    const TreeBody& jaws = world.body(0);
    world.AddContact({.a = {0, 2},
                      .b = {0, 1},
                      .normal_G = x,
                      .gap_m = jaws.angle_rad(2) - jaws.angle_rad(1),
                      .material = {1e5, 300.0, 0.5, 0.0}});
    world.body(0).AddJointTorque(1, 20.0);
    world.body(0).AddJointTorque(2, -20.0);
    world.Step(step_s());
  }
  EXPECT_NEAR(world.contacts()[0].impulse_G.x(), 20.0 * step_s(), 1e-6 * step_s());
  EXPECT_NEAR(world.body(0).angle_rad(1) - world.body(0).angle_rad(2), 20.0 / 1e5, 1e-9);
}

}  // namespace
}  // namespace dockyard
