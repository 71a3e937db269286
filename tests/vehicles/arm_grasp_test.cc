// Stones grasped by the arm, from the motors' angles and currents alone.
#include <gtest/gtest.h>

#include <cmath>

#include "vehicles/stone_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

/// A rover at rest, with a stone under its arm.
struct Standing : ArmRig {
  Standing(const std::string& soil, double length_m, std::uint64_t key, double friction = 0.6)
      : ArmRig(RoverRig::Model("rocky7"), soil, friction) {
    Run(1.0);
    const Eigen::Vector2d at = PointUnderArm();
    Add(OnGround(LooseStoneShape(length_m, key), at.x(), at.y(), 0.0));
  }
};

TEST(ArmGrasp, LiftsAStoneAndHoldsItForTenSecondsOnEitherSoil) {
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    Standing rig(soil, 0.04, 3);
    Grasp(rig, {}, 0.35);
    EXPECT_GT(rig.StoneHeight(0), 0.08) << soil;
    rig.Run(1.0);
    const Vector3d from = rig.StoneInArm(0);
    rig.Run(10.0);
    EXPECT_LT((rig.StoneInArm(0) - from).norm(), 0.5e-3) << soil;
  }
}

// About their axis the stone's forces on a scoop balance its motor and its weight: N = tau / lever.
TEST(ArmGrasp, PressesAsTheMotorsTorqueOverTheLever) {
  Standing rig("compact_gravel", 0.05, 1);
  Grasp(rig, {}, 0.35);
  rig.Run(2.0);
  const double limit_nm = 0.6, friction_nm = 0.03;
  for (const int motor : {kFrontScoop, kBackScoop}) {
    const int link = rig.body.arm().link(motor);
    const TreeBody& tree = rig.body.tree();
    const Vector3d axis_G = tree.motion(link).X_GL.R.col(1), at_G = tree.motion(link).X_GL.p;
    double moment_nm = 0.0;
    for (const WorldContact& contact : rig.world.contacts()) {
      if (contact.a.body != rig.body.number() || contact.a.link != link) continue;
      moment_nm += axis_G.dot((contact.p_G - at_G).cross(1e3 * contact.impulse_G));
    }
    const LinkModel& scoop = tree.link(link).model;
    const Vector3d arm_G = tree.motion(link).X_GL.R * scoop.p_LoCom_L;
    const double weight_nm =
        axis_G.dot(arm_G.cross(Vector3d(0.0, 0.0, -scoop.mass_kg * kEarthGravity_m_s2)));
    const double torque_nm = rig.body.output(rig.first_motor() + motor).torque_nm();
    EXPECT_NEAR(moment_nm, -torque_nm - weight_nm, 2e-3);
    EXPECT_NEAR(std::abs(moment_nm), limit_nm, friction_nm + std::abs(weight_nm) + 1e-3);
  }
}

// A controller feels it: the motors' currents are at their limit with a stone between the scoops,
// and at that of turning alone when they close on nothing.
TEST(ArmGrasp, ClosesOnNothingWithoutAStone) {
  ArmRig rig(RoverRig::Model("rocky7"), "loose_sand");
  rig.Run(1.0);
  EXPECT_EQ(Grasp(rig, {}, 0.35), GraspEnd::kClosed);
}

// What the scoops push together, and what they let go, is nowhere steeper than sand lies.
TEST(ArmGrasp, LeavesNoGroundSteeperThanItsSoilLies) {
  const double tan_phi = std::tan(SoilNamed("loose_sand").friction_angle_rad);
  for (const bool stone : {true, false}) {
    Standing rig("loose_sand", stone ? 0.05 : 0.01, 4);
    for (int i = 0; i < 2; ++i) {
      Grasp(rig, {}, 0.35);
      EXPECT_LT(Steepest(rig.ground, rig.Axis().head<2>(), 0.1), tan_phi + 0.01) << stone << i;
    }
    for (const auto& [scoop, by_rad] : {std::pair{kFrontScoop, -0.9}, {kBackScoop, 0.9}}) {
      rig.Turn(scoop, rig.angle_rad(scoop) + by_rad);
    }
    rig.Run(3.0);
    EXPECT_LT(Steepest(rig.ground, rig.Axis().head<2>(), 0.1), tan_phi + 0.01) << stone;
  }
}

TEST(ArmGrasp, LeavesARockOfTwelveCentimetresWhereItIs) {
  for (const char* soil : {"loose_sand", "compact_gravel"}) {
    Standing rig(soil, 0.12, 2);
    const double height_m = rig.StoneHeight(0);
    Grasp(rig, {}, 0.35);
    EXPECT_LT(rig.StoneHeight(0), height_m + 0.01) << soil;
  }
}

// Sideways only friction holds: at 0.6 a pull of 2 N moves the stone by what the contacts give, at
// 0.1 it slides out at the open side.
TEST(ArmGrasp, LosesHoldOfASlipperyStoneThatIsPulledByTwoNewtons) {
  for (const double friction : {0.6, 0.1}) {
    Standing rig("compact_gravel", 0.05, 1, friction);
    Grasp(rig, {}, 0.35);
    rig.Run(1.0);
    const Vector3d from = rig.StoneInArm(0);
    for (int i = 0; i < 1000; ++i) {
      rig.stones.AddForce(0, {0.0, 2.0, 0.0});
      rig.Step();
    }
    const double moved_m = (rig.StoneInArm(0) - from).norm();
    if (friction > 0.5) {
      EXPECT_LT(moved_m, 0.2e-3);
    } else {
      EXPECT_GT(moved_m, 0.02);
    }
  }
}

TEST(ArmGrasp, GivesTheSameBitsAgain) {
  const auto Hash = [] {
    Standing rig("loose_sand", 0.04, 5);
    Grasp(rig, {}, 0.1);
    return rig.world.StateHash(rig.stones.StateHash(rig.body.StateHash(1)));
  };
  EXPECT_EQ(Hash(), Hash());
}

}  // namespace
}  // namespace dockyard
