// Spring pins against their line of force, and which pads they meet.
#include "sim/vehicles/spring_pins.h"

#include <gtest/gtest.h>

#include "rigid/world_scenes.h"
#include "sim/vehicles/rover_parts.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kStep_s = 1e-3;

SpringPin PinAlongX() {
  return {.contact = "charge",
          .pole = "plus",
          .stroke_m = 0.004,
          .first_n = 0.8,
          .last_n = 2.0,
          .friction = 0.2,
          .damping_ns_per_m = 2.0,
          .closes_n = 0.3};
}

// z out of the plate against x.
ContactPad PadAgainstX(const Vector3d& middle_L) {
  Eigen::Matrix3d R;
  R << 0.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  return {.contact = "charge",
          .pole = "plus",
          .link = 0,
          .X_LP = {R, middle_L},
          .width_m = 0.016,
          .height_m = 0.020};
}

/// A pin on a mount at the origin, and a block on a slide along x whose face x = 0 has a pad.
struct PinScene {
  explicit PinScene(const Vector3d& pad_m = {0, 0, 0}, const SpringPin& pin = PinAlongX())
      : world(Vector3d::Zero()) {
    const int mount = world.Add(TreeBody({Mount()}, {}, Pose3{}, kMounted));
    block = world.Add(TreeBody({Mount(), JointedLink(0, BoxModel(2.0, {0.1, 0.1, 0.1}), {0, 0, 0},
                                                     Vector3d::UnitX(), JointKind::kSlide)},
                               {}, Pose3{}, kMounted));
    PinSide of_pin{.body = mount, .places = {0}, .pins = {pin}};
    PinSide of_pad{.body = block, .places = {1}, .pads = {PadAgainstX(pad_m)}};
    of_pad.solids.push_back({0, BoxAt({0.05, 0.0, 0.0}, {0.1, 0.1, 0.1})});
    pins = SpringPins(of_pin, of_pad);
  }
  void Step(double push_n) {
    world.body(block).AddJointTorque(1, -push_n);
    pins.AddContacts(world);
    world.Step(kStep_s);
    pins.TakeForces(world, kStep_s);
  }
  double pressed_m() const { return -world.body(block).angle_rad(1); }

  RigidWorld world;
  int block = 0;
  SpringPins pins;
};

TEST(SpringPins, YieldAlongTheirLineOfForce) {
  const SpringPin pin = PinAlongX();
  for (const double force_n : {0.9, 1.4, 1.9}) {
    PinScene scene;
    for (int i = 0; i < 20'000; ++i) scene.Step(force_n);
    const double expected_m = pin.stroke_m * (force_n - pin.first_n) / (pin.last_n - pin.first_n);
    EXPECT_NEAR(scene.pressed_m(), expected_m, 2e-5) << force_n;
    EXPECT_NEAR(scene.pins.states()[0].force_n, force_n, 1e-3);
  }
}

TEST(SpringPins, DoNotYieldBeforeTheirFirstForceAndNotBeyondTheirStroke) {
  PinScene light, heavy;
  for (int i = 0; i < 20'000; ++i) light.Step(0.5);
  for (int i = 0; i < 20'000; ++i) heavy.Step(20.0);
  EXPECT_LT(light.pressed_m(), 1e-5);
  EXPECT_NEAR(heavy.pressed_m(), 0.004, 2e-4);
}

TEST(SpringPins, ConductOnTheirPadAboveTheirLeastForceAlone) {
  PinScene scene, off_pad({0, 0.02, 0}), light;
  SpringPin other = PinAlongX();
  other.pole = "minus";
  PinScene reversed({0, 0, 0}, other);
  for (int i = 0; i < 10'000; ++i) {
    scene.Step(1.5);
    off_pad.Step(1.5);
    reversed.Step(1.5);
    light.Step(0.2);
  }
  EXPECT_TRUE(scene.pins.IsClosed("charge"));
  EXPECT_NEAR(scene.pins.Force("charge"), 1.5, 3e-3);
  EXPECT_FALSE(off_pad.pins.IsClosed("charge"));
  EXPECT_NEAR(off_pad.pins.Offset("charge", off_pad.world), 0.02, 1e-6);
  EXPECT_FALSE(reversed.pins.IsClosed("charge"));
  EXPECT_FALSE(light.pins.IsClosed("charge"));
  EXPECT_FALSE(scene.pins.IsClosed("data"));
}

TEST(SpringPins, PushTheirOwnBodyAsHard) {
  // Both free in space: momentum stays 0 as the pin's spring drives them apart.
  RigidWorld world(Vector3d::Zero());
  const int a = world.Add(FreeBody(BoxModel(1.0, {0.1, 0.1, 0.1}), Pose3{}));
  const int b =
      world.Add(FreeBody(BoxModel(3.0, {0.1, 0.1, 0.1}), Pose3::Translation(0.103, 0.0, 0.0)));
  SpringPin pin = PinAlongX();
  pin.p_L = {0.056, 0.0, 0.0};
  PinSide on_b{.body = b, .places = {0}};
  on_b.solids.push_back({0, BoxAt({0, 0, 0}, {0.1, 0.1, 0.1})});
  SpringPins pins({.body = a, .places = {0}, .pins = {pin}}, on_b);
  for (int i = 0; i < 200; ++i) {
    pins.AddContacts(world);
    world.Step(kStep_s);
  }
  const double v_a = world.body(a).motion(0).v_GL_G.x(), v_b = world.body(b).motion(0).v_GL_G.x();
  EXPECT_LT(v_a, -0.01);
  EXPECT_NEAR(v_a + 3.0 * v_b, 0.0, 1e-12);
}

}  // namespace
}  // namespace dockyard
