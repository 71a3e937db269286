#include "sim/axel/rover_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/afloat.h"
#include "rigid/principal_inertia.h"
#include "sim/axel/drive_train.h"

namespace dockyard::axel {
namespace {

constexpr double kDt = 1e-3;

struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
};

/// About the site's origin. Rotors do not count: by their gears' ratio they carry 1 / N of what
/// they resist.
Momentum TotalMomentum(const Afloat& world) {
  Momentum sum;
  for (RoverLink link : kAllLinks) {
    const LinkModel& model = LinkOf(world.model, link);
    const LinkMotion& motion = world.rover.motion(link);
    const Eigen::Vector3d com = motion.X_GL * model.p_LoCom_L;
    const Eigen::Matrix3d& I = model.I_LCom_L;
    const Eigen::Vector3d p = model.mass_kg * motion.VelocityAt(com);
    sum.linear += p;
    sum.angular += com.cross(p) + motion.X_GL.R * I * motion.X_GL.R.transpose() * motion.w_GL_G;
  }
  return sum;
}

TEST(RoverBody, FallsAsSymplecticEulerFalls) {
  Afloat world(9.81);
  const double z0 = world.rover.motion(RoverLink::kBody).X_GL.p.z();
  for (int i = 0; i < 1000; ++i) world.contacts.Step(kDt);
  // Sum of g k dt^2 for k = 1..1000.
  EXPECT_NEAR(world.rover.motion(RoverLink::kBody).X_GL.p.z() - z0, -9.81 * 0.5 * 1.001, 1e-9);
}

/// Momentum that inner torques have made out of nothing after half a second.
Momentum MomentumError(double dt) {
  Afloat world(0.0);
  for (long i = 0; i < std::lround(0.5 / dt); ++i) {
    world.rover.AddJointTorque(RoverLink::kArm, 3.0);
    world.rover.AddJointTorque(RoverLink::kLeftWheel, 2.0);
    world.rover.AddJointTorque(RoverLink::kRightWheel, -1.0);
    world.contacts.Step(dt);
  }
  return TotalMomentum(world);
}

TEST(RoverBody, InnerTorquesMakeNoMomentumButByTheStepsFirstOrderError) {
  const Momentum coarse = MomentumError(2e-3), fine = MomentumError(1e-3);
  // Wheels and arm exchange some 1 kg m/s within.
  EXPECT_LT(fine.linear.norm(), 5e-3);
  EXPECT_LT(fine.linear.norm(), 0.6 * coarse.linear.norm() + 1e-9);
  EXPECT_LT(fine.angular.norm(), 0.6 * coarse.angular.norm() + 1e-9);
}

TEST(RoverBody, ArmSwingsWithThePeriodOfAPendulum) {
  // A body so heavy that the arm's hinge stands still, the arm hanging down.
  RoverModel model = Axel();
  model.body.mass_kg = 1e9;
  model.body.I_LCom_L = 1e9 * Eigen::Matrix3d::Identity();
  model.body.p_LoCom_L.setZero();
  Afloat world(model, Station(), kWeightless, Pose3::Translation(50.0, 0, 0), 0.5 * kPi + 0.01);
  RoverBody& rover = world.rover;
  double last = 0.01, first_crossing = 0.0, last_crossing = 0.0;
  int crossings = 0;
  for (int i = 1; i <= 20000; ++i) {
    const LinkMotion& arm = rover.motion(RoverLink::kArm);
    rover.AddForce(RoverLink::kArm, Eigen::Vector3d(0, 0, -4.0 * 9.81),
                   arm.X_GL * Eigen::Vector3d(0.5, 0, 0));
    world.contacts.Step(kDt);
    const double swing = rover.joint_rad(RoverLink::kArm) - 0.5 * kPi;
    if (last < 0.0 && swing >= 0.0) {
      last_crossing = kDt * (i - swing / (swing - last));
      if (crossings == 0) first_crossing = last_crossing;
      ++crossings;
    }
    last = swing;
  }
  const double inertia = 0.33384 + 4.0 * 0.25 + 2.0;  // own, to the hinge, rotor
  const double period = 2.0 * kPi * std::sqrt(inertia / (4.0 * 9.81 * 0.5));
  ASSERT_GT(crossings, 4);
  EXPECT_NEAR((last_crossing - first_crossing) / (crossings - 1), period, 1e-3 * period);
}

TEST(RoverBody, MassMatrixGivesTheLinksKineticEnergyAndJacobiansTheirVelocities) {
  const RoverModel model = Axel();
  RigidWorld world(kWeightless);
  RoverBody rover(world, model, {RotZ(0.4) * RotY(0.3) * RotX(0.2), Eigen::Vector3d(5.0, 1.0, 2.0)},
                  0.7, false);
  TreeBody::Speeds speeds(9);
  speeds << 0.3, -0.2, 0.1, 0.5, 0.7, -0.4, 1.1, -0.9, 0.6;
  rover.tree().AddSpeeds(speeds);
  double energy = 0.0;
  for (int i = 0; i < kOwnLinkCount; ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    const LinkModel& own = LinkOf(model, link);
    const LinkMotion& motion = rover.motion(link);
    const Eigen::Vector3d w = motion.X_GL.R.transpose() * motion.w_GL_G;
    const Eigen::Vector3d v = motion.VelocityAt(motion.X_GL * own.p_LoCom_L);
    energy += 0.5 * own.mass_kg * v.squaredNorm() + 0.5 * w.dot(own.I_LCom_L * w);
    if (i > 0) {
      energy += 0.5 * model.motors[i - 1].reflected_inertia_kg_m2 * speeds[5 + i] * speeds[5 + i];
    }
    const Eigen::Vector3d p_G = motion.X_GL * Eigen::Vector3d(0.4, 0.1, -0.2);
    const TreeBody::PointJacobian J = rover.tree().JacobianOf(rover.Place(link).link, p_G);
    EXPECT_LT((J * speeds - motion.VelocityAt(p_G)).norm(), 1e-12);
  }
  EXPECT_NEAR(0.5 * speeds.dot(rover.tree().MassMatrix() * speeds), energy, 1e-12 * energy);
}

TEST(RoverBody, OrderOfTheWheelsChangesNothing) {
  const Pose3 X_GR = Pose3::Translation(50.0, 0, 0);
  const Eigen::Vector3d gravity_G(0.0, 0.0, -9.81);
  Afloat left(Axel(), Station(), gravity_G, X_GR, 0.2),
      right(Axel(), Station(), gravity_G, X_GR, 0.2, {}, true);
  RoverBody &a = left.rover, &b = right.rover;
  for (int i = 0; i < 1000; ++i) {
    a.AddJointTorque(RoverLink::kLeftWheel, 1.0);
    b.AddJointTorque(RoverLink::kLeftWheel, 1.0);
    left.contacts.Step(kDt);
    right.contacts.Step(kDt);
  }
  EXPECT_NEAR((a.motion(RoverLink::kArm).X_GL.p - b.motion(RoverLink::kArm).X_GL.p).norm(), 0.0,
              1e-12);
  EXPECT_NEAR(a.joint_rad(RoverLink::kLeftWheel), b.joint_rad(RoverLink::kLeftWheel), 1e-12);
}

TEST(RoverBody, InertiaTurnedFromItsAxesMovesAsTheSameBody) {
  // The same tensor, once as a diagonal and once from a link frame that is turned about z.
  LinkModel link;
  link.mass_kg = 2.0;
  const Eigen::Matrix3d D = Eigen::Vector3d(0.1, 0.2, 0.25).asDiagonal();
  link.I_LCom_L = RotZ(0.7) * D * RotZ(0.7).transpose();
  const PrincipalInertia principal = FindPrincipalInertia(link);
  const Eigen::Matrix3d back =
      principal.X_LP.R * principal.moments.asDiagonal() * principal.X_LP.R.transpose();
  EXPECT_LT((back - link.I_LCom_L).norm(), 1e-14);
  EXPECT_NEAR(principal.X_LP.R.determinant(), 1.0, 1e-12);
}

TEST(RoverBody, PitchedInertiaKeepsItsYAxis) {
  LinkModel link;
  const Eigen::Matrix3d D = Eigen::Vector3d(0.1, 0.2, 0.25).asDiagonal();
  link.I_LCom_L = RotY(0.7) * D * RotY(0.7).transpose();
  link.I_LCom_L(0, 1) = link.I_LCom_L(1, 0) = link.I_LCom_L(1, 2) = link.I_LCom_L(2, 1) = 0.0;
  const PrincipalInertia principal = FindPrincipalInertia(link);
  EXPECT_EQ(principal.X_LP.R.col(1), Eigen::Vector3d(0, 1, 0));
  const Eigen::Matrix3d back =
      principal.X_LP.R * principal.moments.asDiagonal() * principal.X_LP.R.transpose();
  EXPECT_LT((back - link.I_LCom_L).norm(), 1e-14);
}

/// Motor work = tether work + friction loss + the drum's kinetic energy.
void ExpectSpoolWorksForAllItsEnergy(double growth_m_per_turn) {
  Afloat world(0.0);
  world.model.tether.drum_growth_m_per_turn = growth_m_per_turn;
  DriveTrain drives(world.model, 0.3);
  drives.PowerOn(world.rover);
  MotorCommands commands = AllBraked();
  At(commands, Motor::kSpool) = Velocity(0.8, 2.0);
  const double tension = 100.0;
  double motor = 0.0, tether = 0.0, friction = 0.0, reeled_m = 0.0;
  for (int i = 0; i < 3000; ++i) {
    drives.Step(commands, tension, kDt, world.rover);
    const DriveOutput& out = drives.output(Motor::kSpool);
    const double speed = drives.speed_rad_s(Motor::kSpool, world.rover);
    motor += out.motor_torque_nm * speed * kDt;
    friction -= out.friction_torque_nm * speed * kDt;
    reeled_m = -drives.tether_given_m(world.rover);
  }
  // A spiral: the radius grows in proportion to the angle.
  const double turned_rad = drives.angle_rad(Motor::kSpool, world.rover);
  EXPECT_NEAR(reeled_m,
              world.model.tether.drum_radius_m * turned_rad +
                  growth_m_per_turn * turned_rad * turned_rad / (4.0 * kPi),
              1e-12);
  tether = tension * reeled_m;
  const double speed = drives.speed_rad_s(Motor::kSpool, world.rover);
  const double J = world.model.motors[static_cast<int>(Motor::kSpool)].reflected_inertia_kg_m2;
  const double kinetic = 0.5 * J * speed * speed;
  EXPECT_GT(tether, 10.0);
  EXPECT_NEAR(motor, tether + friction + kinetic, 1e-3 * motor);
}

TEST(DriveTrain, SpoolWorksAgainstTheTetherForAllItsEnergy) {
  ExpectSpoolWorksForAllItsEnergy(0.0);
}

TEST(DriveTrain, DrumThatGrowsByItsLayersDoesSoToo) { ExpectSpoolWorksForAllItsEnergy(0.006); }

TEST(DriveTrain, TetherInTheArmTurnsItTipDownAgainstTheBody) {
  Afloat world(0.0);
  DriveTrain drives(world.model, 0.3);
  drives.PowerOn(world.rover);
  MotorCommands commands{};
  for (MotorCommand& command : commands) command = FreeWheel();
  At(commands, Motor::kSpool) = MotorCommand{};  // braked: the drum holds
  for (int i = 0; i < 100; ++i) {
    drives.Step(commands, 200.0, kDt, world.rover);
    world.contacts.Step(kDt);
  }
  EXPECT_GT(world.rover.joint_rad_s(RoverLink::kArm), 0.0);
  EXPECT_LT(world.rover.motion(RoverLink::kBody).w_GL_G.y(), 0.0);
}

}  // namespace
}  // namespace dockyard::axel
