#include "sim/vehicles/wheeled_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/motion/two_arcs.h"
#include "vehicles/rover_rig.h"

namespace dockyard {
namespace {

constexpr double kWheelbase_m = 0.40875, kTrack_m = 0.40;

RoverModel Frictionless(const std::string& name) {
  RoverModel model = RoverRig::Model(name);
  model.suspension.friction_nm = 0.0;
  return model;
}

// Moments about the line of the bogies' joints; a bogie bears alike on both of its wheels.
TEST(WheeledBody, BearsOnItsWheelsAsTheLeversSay) {
  const RoverModel model = Frictionless("rocky7");
  RoverRig rig(model, "compact_gravel");
  rig.Run(2.0);
  const TreeBody& tree = rig.body.tree();
  double moment = 0.0;
  for (int i = 0; i < tree.link_count(); ++i) {
    const LinkModel& link = tree.link(i).model;
    moment += link.mass_kg * (tree.motion(i).X_GL * link.p_LoCom_L).x();
  }
  const double back_m = 0.5 * (rig.body.wheel(2).X_GL.p.x() + rig.body.wheel(4).X_GL.p.x());
  const double weight_n = model.mass_kg() * kEarthGravity_m_s2;
  const double front_n = (moment * kEarthGravity_m_s2 - weight_n * back_m) / (2.0 * kWheelbase_m);
  double sum_n = 0.0;
  for (int i = 0; i < 6; ++i) {
    const double load_n = rig.body.load(i).force_G.z();
    sum_n += load_n;
    EXPECT_NEAR(load_n, i < 2 ? front_n : 0.25 * weight_n - 0.5 * front_n, 0.01 * load_n) << i;
  }
  EXPECT_NEAR(sum_n, weight_n, 1e-3 * weight_n);
}

// One front wheel on a block: its rocker tips by asin(h / L), the body by half of that, and the
// rockers' angles are equal and opposite.
TEST(WheeledBody, TipsByTheMeanOfItsRockers) {
  constexpr double kBlock_m = 0.05;
  const RoverModel model = Frictionless("rocky7");
  RoverRig rig(model, "compact_gravel");
  for (int iy = 0; iy < rig.ground.ny; ++iy) {
    for (int ix = 0; ix < rig.ground.nx; ++ix) {
      const double x = rig.ground.x0_m + ix * rig.ground.cell_m;
      const double y = rig.ground.y0_m + iy * rig.ground.cell_m;
      // A ramp before the left wheel, and a block.
      if (y < 0.1 || y > 0.3 || x < 0.97) continue;
      rig.ground.heights_m[static_cast<std::size_t>(iy * rig.ground.nx + ix)] =
          kBlock_m * std::min(1.0, (x - 0.97) / 0.15);
    }
  }
  rig.Run(1.0);
  rig.Drive({0.8, 0.0});
  rig.Run(2.0);
  const double up_m = rig.body.wheel(0).X_GL.p.z() - rig.body.wheel(1).X_GL.p.z();
  EXPECT_NEAR(up_m, kBlock_m, 0.01);
  const double left = rig.body.rocker_rad(true), right = rig.body.rocker_rad(false);
  EXPECT_NEAR(left + right, 0.0, 1e-9);
  const RollPitchYaw rpy = ToRollPitchYaw(rig.body.body().X_GL.R);
  // Against level ground the pitch of each rocker is that of the line from bogie to front wheel.
  const auto RockerPitch = [&](int front, int middle, int back) {
    const double bogie_z =
        0.5 * (rig.body.wheel(middle).X_GL.p.z() + rig.body.wheel(back).X_GL.p.z());
    return -std::asin((rig.body.wheel(front).X_GL.p.z() - bogie_z) / kWheelbase_m);
  };
  const double left_pitch = RockerPitch(0, 2, 4), right_pitch = RockerPitch(1, 3, 5);
  EXPECT_NEAR(left_pitch, -std::asin(up_m / kWheelbase_m), 0.02);
  EXPECT_NEAR(rpy.pitch, 0.5 * (left_pitch + right_pitch), 2e-3);
  EXPECT_NEAR(left, 0.5 * (left_pitch - right_pitch), 2e-3);
  // At the pivots, 0.12075 m before the bogies, the sides differ by that share of the block.
  EXPECT_NEAR(rpy.roll, 0.12075 / kWheelbase_m * up_m / kTrack_m, 3e-3);
}

// What the planner asks for, driven by the world without a controller.
TEST(WheeledBody, DrivesTheArcThatItsWheelsAreSteeredFor) {
  RoverRig rig(RoverRig::Model("rocky7"), "compact_gravel");
  rig.Run(1.0);
  const Pose2 from = rig.X_GR();
  const Arc arc{0.5 * kPi, 0.5 * kPi};  // a quarter of a circle of 1 m
  rig.Steer(arc);
  rig.Drive(arc);
  const Pose2 moved = Inverse(from) * rig.X_GR();
  const double radius_m = std::hypot(moved.x, moved.y) / (2.0 * std::sin(0.5 * moved.heading));
  EXPECT_NEAR(radius_m, 1.0, 0.05);
  EXPECT_GT(moved.heading, 0.8 * 0.5 * kPi);
}

// The six classes of Nesnas, Maimone and Das, Fig. 1, on one S-curve. Steered wheels bring a rover
// to its end but for slip; one that skids turns less than half as far as its wheels say.
TEST(WheeledBody, DrivesAnSCurveInEveryClassOfRover) {
  const Pose2 goal{1.2, 0.4, 0.0};
  const auto pair = CheapestPair(goal, {0.5});
  ASSERT_TRUE(pair);
  for (const char* name :
       {"skid_four", "ackermann_four", "steered_four", "rocky7", "corners_six", "steered_six"}) {
    RoverRig rig(RoverRig::Model(name), "compact_gravel");
    rig.Run(1.0);
    const Pose2 from = rig.X_GR();
    for (const Arc& arc : *pair) {
      rig.Steer(arc);
      rig.Drive(arc);
    }
    const Pose2 moved = Inverse(from) * rig.X_GR();
    const bool skids = std::string(name) == "skid_four";
    EXPECT_LT(std::hypot(moved.x - goal.x, moved.y - goal.y), skids ? 0.3 : 0.15) << name;
    EXPECT_LT(std::abs(moved.heading), Radians(5.0)) << name;
    EXPECT_EQ(moved.y < 0.6 * goal.y, skids) << name;
  }
}

TEST(WheeledBody, GivesTheSameBitsAgain) {
  const auto Hash = [] {
    RoverRig rig(RoverRig::Model("rocky7"), "loose_sand");
    rig.Run(0.5);
    rig.Drive({0.05, 0.0});
    return rig.world.StateHash(rig.body.StateHash(1));
  };
  EXPECT_EQ(Hash(), Hash());
}

}  // namespace
}  // namespace dockyard
