// Belts on firm ground against closed forms: Hooke, Coulomb, Janosi and Hanamoto.
#include "sim/vehicles/belt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/base/hash.h"
#include "vehicles/belt_rig.h"

namespace dockyard {
namespace {

constexpr double kLength_m = 0.386, kGauge_m = 0.426;

BeltRig Settled(const BeltGround& ground) {
  BeltRig rig = TwoBelts(kLength_m, kGauge_m, 0.0, ground);
  rig.Run(0.5);
  return rig;
}

/// The rig is held, and drawn along G by so much with its belts at this speed. Force on it at the
/// end.
Eigen::Vector3d Drag(BeltRig& rig, const Eigen::Vector3d& v_G, double way_m, double dt_s = 1e-3) {
  rig.v_GCom_G = v_G;
  rig.w_GR_G.setZero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (long i = std::lround(way_m / (v_G.norm() * dt_s)); i > 0; --i) {
    force = rig.Load(dt_s).first;
    rig.X_GR.p += dt_s * v_G;
  }
  return force;
}

/// A grid that rises along its x by this angle, through the origin.
HeightGrid Ramp(double up_rad) {
  HeightGrid grid = LevelGrid(-3.0, 6.0, 6.0, 0.1);
  for (int iy = 0; iy < grid.ny; ++iy) {
    for (int ix = 0; ix < grid.nx; ++ix) {
      grid.heights_m[static_cast<std::size_t>(iy * grid.nx + ix)] =
          (grid.x0_m + ix * grid.cell_m) * std::tan(up_rad);
    }
  }
  return grid;
}

TEST(Belt, CarriesTheWeightAtTheDepthOfHookesLaw) {
  const BeltRig rig = Settled(kHardFloor);
  const BeltModel& belt = rig.belts[0].model;
  const double depth = belt.front.radius_m - rig.X_GR.p.z();
  // Each roller presses half a parabola of depth beyond the straight run.
  const double beyond = std::sqrt(2.0 * belt.front.radius_m * depth);
  const double area = 2.0 * belt.width_m * depth * (kLength_m + 2.0 * 2.0 / 3.0 * beyond);
  EXPECT_NEAR(belt.stiffness_pa_per_m * area, rig.Weight(), 1e-4 * rig.Weight());
  EXPECT_NEAR(rig.belts[0].load.normal_n, 0.5 * rig.Weight(), 1e-6 * rig.Weight());
  EXPECT_NEAR(rig.belts[0].load.front_m, 0.5 * kLength_m + beyond, 2e-4);
  EXPECT_NEAR(rig.belts[0].load.rear_m, -0.5 * kLength_m - beyond, 2e-4);
}

// A window that ends where the loop does must not reach a pad beyond its last one, nor one before
// its first, however its length is rounded. A roller of this radius, drawn for RAPOSA's arm, did.
TEST(Belt, HasNoPadBeyondItsLoop) {
  BeltModel model = TwoBelts(kLength_m, kGauge_m, 0.0, kHardFloor).belts[0].model;
  model.front = {.x_m = 0.18, .radius_m = 0.09 + 0.00013780593400224882};
  model.rear = {.x_m = 0.0, .radius_m = model.front.radius_m};
  model.pads = 22;
  const HeightGrid ground = LevelGrid(-3.0, 6.0, 6.0, 3.0);
  for (int depth = 0; depth < 40; ++depth) {
    for (int pitch = -20; pitch <= 20; ++pitch) {
      Belt belt(model, kHardFloor);
      LinkMotion carrier;
      carrier.X_GL.R = RotY(5e-4 * pitch);
      carrier.X_GL.p.z() = model.front.radius_m - 2e-5 * depth;
      for (int i = 0; i < 3; ++i) {
        EXPECT_NO_THROW(belt.Step(ground, carrier, 1e-16 * (i - 1), 1e-3));
      }
    }
  }
}

TEST(Belt, NeverPulls) {
  BeltRig rig = Settled(kHardFloor);
  rig.v_GCom_G.z() = 5.0;
  EXPECT_EQ(rig.Load(1e-3).first.norm(), 0.0);
}

TEST(Belt, ForgetsItsGripWhenLifted) {
  BeltRig rig = Settled(kGrass), fresh = Settled(kGrass);
  Drag(rig, {0.1, 0.05, 0.0}, 0.05);
  rig.X_GR = fresh.X_GR;
  rig.X_GR.p.z() += 0.01;
  rig.v_GCom_G.setZero();
  rig.Load(1e-3);
  rig.X_GR = fresh.X_GR;
  EXPECT_LT(rig.Load(1e-3).first.head<2>().norm(), 1e-9);
}

TEST(Belt, PullsWithItsWholeStrengthAtFullSlip) {
  for (const BeltGround& ground : {kHardFloor, kGrass}) {
    BeltRig rig = Settled(ground);
    rig.Drive(0.5, 0.5);
    rig.v_GCom_G.setZero();
    Eigen::Vector3d force;
    for (int i = 0; i < 3000; ++i) force = rig.Load(1e-3).first;
    double area = 0.0;
    for (const RigBelt& belt : rig.belts) {
      area += belt.model.width_m * (belt.load.front_m - belt.load.rear_m);
    }
    // A pad slides by as much as it has travelled: the mean of 1 - exp(-s / K) over the length.
    const double strength = ground.friction * rig.Weight() + ground.cohesion_pa * area;
    const double share = 1.0 - ground.shear_displacement_m / kLength_m;
    EXPECT_NEAR(force.x(), share * strength, 0.005 * strength);
    // The motor gives the traction and the rolling loss.
    const double loss = ground.rolling_loss * force.z();
    const double torque = rig.belts[0].load.drive_torque_nm + rig.belts[1].load.drive_torque_nm;
    EXPECT_NEAR(torque, (force.x() + loss) * rig.belts[0].model.sprocket_radius_m, 1e-6);
  }
}

TEST(Belt, MobilisesItsStrengthByJanosiAndHanamoto) {
  BeltGround soil = kGrass;
  soil.cohesion_pa = 0.0;
  const double K = soil.shear_displacement_m;
  BeltRig rig = Settled(soil);
  double slid = 0.0;
  for (const double step : {0.1 * K, 0.4 * K, 0.5 * K, K, 3.0 * K}) {
    const double force = -Drag(rig, {0.1, 0.0, 0.0}, step, 1e-4).x();
    slid += step;
    EXPECT_NEAR(force / (soil.friction * rig.Weight()), 1.0 - std::exp(-slid / K), 0.01) << slid;
  }
}

TEST(Belt, SlidesSidewaysAgainstTheLateralShare) {
  for (const double ratio : {0.8, 1.0, 1.2}) {
    BeltGround ground = kHardFloor;
    ground.lateral_ratio = ratio;
    BeltRig rig = Settled(ground);
    const Eigen::Vector3d aside = Drag(rig, {0.0, 0.1, 0.0}, 0.05);
    const Eigen::Vector3d oblique = Drag(rig, {0.1, 0.1, 0.0}, 0.05);
    const double most = ground.friction * rig.Weight();
    EXPECT_NEAR(aside.y(), -ratio * most, 1e-6 * most);
    EXPECT_NEAR(oblique.x(), -most * std::sqrt(0.5), 1e-4 * most);
    EXPECT_NEAR(oblique.y(), -ratio * most * std::sqrt(0.5), 1e-4 * most);
  }
}

TEST(Belt, HoldsForAMinuteBelowTheAngleOfFriction) {
  for (const double heading : {0.0, 0.25 * kPi, 0.5 * kPi}) {
    for (const double share : {0.3, 0.95}) {
      BeltRig rig = Settled(kHardFloor);
      const double slope = std::atan(share * kHardFloor.friction);
      rig.gravity_G = 9.81 * Eigen::Vector3d(std::sin(slope) * std::cos(heading),
                                             std::sin(slope) * std::sin(heading), -std::cos(slope));
      rig.Run(2.0);
      const Pose3 before = rig.X_GR;
      rig.Run(60.0, 2e-3);
      EXPECT_LT((rig.X_GR.p - before.p).norm(), 1e-9) << heading << " " << share;
      EXPECT_LT((rig.X_GR.R - before.R).norm(), 1e-9) << heading << " " << share;
    }
  }
}

TEST(Belt, SlidesAboveTheAngleOfFriction) {
  BeltRig rig = Settled(kHardFloor);
  const double slope = std::atan(0.8);
  rig.gravity_G = 9.81 * Eigen::Vector3d(std::sin(slope), 0.0, -std::cos(slope));
  rig.Run(0.3);
  const double speed = rig.v_GCom_G.x();
  rig.Run(0.5);
  EXPECT_NEAR(rig.v_GCom_G.x() - speed, 0.5 * 9.81 * (std::sin(slope) - 0.6 * std::cos(slope)),
              0.005);
}

TEST(Belt, StandsOnARampAsOnALevelThatLeans) {
  const double up = Radians(12.0);
  const Eigen::Matrix3d lean = Eigen::AngleAxisd(-up, Eigen::Vector3d::UnitY()).toRotationMatrix();
  BeltRig ramp = TwoBelts(kLength_m, kGauge_m), level = TwoBelts(kLength_m, kGauge_m);
  ramp.ground = Ramp(up);
  ramp.X_GR = {lean, lean * level.X_GR.p};
  level.gravity_G = lean.transpose() * level.gravity_G;
  for (BeltRig* rig : {&ramp, &level}) {
    rig->Run(1.0);
    rig->Drive(0.1, 0.2);
    rig->Run(2.0);
  }
  EXPECT_LT((lean.transpose() * ramp.X_GR.p - level.X_GR.p).norm(), 1e-6);
  EXPECT_LT((lean.transpose() * ramp.X_GR.R - level.X_GR.R).norm(), 1e-6);
}

TEST(Belt, DrivesStraightAtTheBeltsSpeedAndRestsAgain) {
  BeltRig rig = ArmedRobot(0.0);
  rig.Run(0.5);
  rig.Drive(0.1, 0.1);
  rig.Run(5.0);
  EXPECT_NEAR(rig.VelocityInR().x(), 0.1, 1e-5);
  EXPECT_LT(std::fabs(rig.w_GR_G.z()), 1e-12);
  EXPECT_LT(std::fabs(rig.X_GR.p.y()), 1e-9);
  rig.Drive(0.0, 0.0);
  rig.Run(1.0);
  const Eigen::Vector3d p = rig.X_GR.p;
  rig.Run(10.0);
  EXPECT_LT((rig.X_GR.p - p).norm(), 1e-9);
}

TEST(Belt, DrivesTheOtherWayUpsideDown) {
  BeltRig rig = ArmedRobot(0.0);
  rig.X_GR.R = Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  rig.Run(0.5);
  rig.Drive(0.1, 0.1);
  rig.Run(2.0);
  EXPECT_NEAR(rig.VelocityInR().x(), -0.1, 1e-4);
}

TEST(Belt, WithoutFrictionTurnsNothing) {
  BeltGround ice = kHardFloor;
  ice.friction = 0.0;
  BeltRig rig = ArmedRobot(0.0, ice);
  rig.Run(0.5);
  rig.Drive(-0.3, 0.3);
  rig.Run(5.0);
  EXPECT_LT(std::fabs(rig.w_GR_G.z()), 1e-7);
  EXPECT_EQ(rig.belts[0].load.traction_n, 0.0);
}

TEST(Belt, MeetsPatchesThatDifferAsTold) {
  const FrictionPatches patches{0.1, 0.2, 7};
  double mean = 0.0, square = 0.0;
  constexpr int kSide = 200;
  for (int i = 0; i < kSide * kSide; ++i) {
    const double x = 0.2 * (i % kSide - 100) + 0.05, y = 0.2 * (i / kSide - 100) + 0.05;
    const double off = FrictionFactor(patches, x, y) - 1.0;
    EXPECT_EQ(off, FrictionFactor(patches, x + 0.1, y + 0.1) - 1.0);
    mean += off / (kSide * kSide);
    square += off * off / (kSide * kSide);
  }
  EXPECT_NEAR(mean, 0.0, 5.0 * 0.1 / std::sqrt(3.0) / kSide);
  EXPECT_NEAR(square, 0.01 / 3.0, 0.02 * 0.01 / 3.0);  // of a uniform number within 0.1

  // Dragged over one patch, the belts meet its friction; turning over many, their own each.
  BeltRig rig = Settled(kHardFloor);
  for (Belt& belt : rig.contacts) belt.SetPatches({0.1, 100.0, 3});
  rig.X_GR.p += Eigen::Vector3d(50.0, 50.0, 0.0);
  const double factor = FrictionFactor({0.1, 100.0, 3}, 50.0, 50.0);
  const double most = kHardFloor.friction * rig.Weight();
  EXPECT_NEAR(-Drag(rig, {0.1, 0.0, 0.0}, 0.05).x(), factor * most, 1e-6 * most);
  EXPECT_GT(std::fabs(factor - 1.0), 1e-3);
  BeltRig turning = Settled(kHardFloor);
  for (Belt& belt : turning.contacts) belt.SetPatches(patches);
  turning.Drive(-0.1, 0.1);
  turning.Run(3.0);
  EXPECT_GT(turning.X_GR.p.head<2>().norm(), 1e-4);  // in place only where all is alike
}

TEST(Belt, MirroredDrivesTheMirroredWay) {
  BeltRig left = ArmedRobot(0.0), right = ArmedRobot(0.0);
  left.Drive(0.05, 0.15);
  right.Drive(0.15, 0.05);
  left.Run(5.0);
  right.Run(5.0);
  EXPECT_NEAR(left.X_GR.p.x(), right.X_GR.p.x(), 1e-9);
  EXPECT_NEAR(left.X_GR.p.y(), -right.X_GR.p.y(), 1e-9);
  EXPECT_GT(left.X_GR.p.y(), 0.05);
}

TEST(Belt, GivesTheSameBitsForTheSameCalls) {
  BeltRig one = ArmedRobot(Radians(10.0), kGrass), other = ArmedRobot(Radians(10.0), kGrass);
  one.Drive(0.05, 0.15);
  other.Drive(0.05, 0.15);
  one.Run(1.0);
  other.Run(1.0);
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    EXPECT_EQ(one.contacts[i].StateHash(kHashSeed), other.contacts[i].StateHash(kHashSeed));
  }
  other.Step(1e-3);
  EXPECT_NE(one.contacts[0].StateHash(kHashSeed), other.contacts[0].StateHash(kHashSeed));
}

}  // namespace
}  // namespace dockyard
