// What the rotors of geared joints resist.
#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/afloat.h"

namespace dockyard::axel {
namespace {

constexpr double kDt = 1e-3;

/// Of all links and of the rotors against their joints' turning [J].
double KineticEnergy(const Afloat& world) {
  double sum = 0.0;
  for (RoverLink link : kAllLinks) {
    const LinkModel& model = LinkOf(world.model, link);
    const LinkMotion& motion = world.rover.motion(link);
    const Eigen::Vector3d v = motion.VelocityAt(motion.X_GL * model.p_LoCom_L);
    const Eigen::Vector3d w = motion.X_GL.R.transpose() * motion.w_GL_G;
    sum += 0.5 * model.mass_kg * v.squaredNorm() + 0.5 * w.dot(model.I_LCom_L * w);
    if (link == RoverLink::kBody) continue;
    const double q = world.rover.joint_rad_s(link);
    const double J = world.model.motors[static_cast<int>(link) - 1].reflected_inertia_kg_m2;
    sum += 0.5 * J * q * q;
  }
  return sum;
}

/// Work of three joints' torques in half a second, less the kinetic energy.
double EnergyError(double dt, double x) {
  Afloat world(0.0, x);
  const std::array<double, 4> torque = {0.0, 2.0, -1.0, 3.0};
  double work = 0.0;
  for (long i = 0; i < std::lround(0.5 / dt); ++i) {
    for (int link = 1; link < 4; ++link) {
      const RoverLink joint = static_cast<RoverLink>(link);
      world.rover.AddJointTorque(joint, torque[link]);
      work -= world.rover.joint_rad(joint) * torque[link];
    }
    world.contacts.Step(dt);
    for (int link = 1; link < 4; ++link) {
      work += world.rover.joint_rad(static_cast<RoverLink>(link)) * torque[link];
    }
  }
  return (work - KineticEnergy(world)) / work;
}

TEST(Rotors, TakeTheirShareOfTheJointsWork) {
  const double coarse = EnergyError(2e-3, 50.0), fine = EnergyError(1e-3, 50.0);
  EXPECT_LT(std::abs(fine), 5e-3);
  EXPECT_NEAR(coarse / fine, 2.0, 0.2);
}

TEST(Rotors, DoNotResistTheBodyThatTurnsAsAWhole) {
  // Each link gets the torque that turns it by itself at 1 rad/s^2, so no joint moves.
  RoverModel model = Axel();
  model.body.p_LoCom_L.setZero();
  model.arm.p_LoCom_L.setZero();
  Afloat world(model, Station(), kWeightless, Pose3::Translation(50.0, 0, 0), 0.0);
  RoverBody& rover = world.rover;
  for (int i = 0; i < 100; ++i) {
    for (RoverLink link : kAllLinks) {
      rover.AddTorque(link, Eigen::Vector3d(0.0, LinkOf(model, link).I_LCom_L(1, 1), 0.0));
    }
    world.contacts.Step(kDt);
  }
  EXPECT_NEAR(rover.motion(RoverLink::kBody).w_GL_G.y(), 0.1, 1e-12);
  EXPECT_NEAR(rover.joint_rad_s(RoverLink::kArm), 0.0, 1e-12);
}

TEST(Rotors, ResistTheJointsTurningByTheirWholeInertia) {
  // A wheel against a body that cannot turn: I + J.
  RoverModel model = Axel();
  model.body.mass_kg = 1e9;
  model.body.I_LCom_L = 1e9 * Eigen::Matrix3d::Identity();
  Afloat world(model, Station(), kWeightless, Pose3::Translation(50.0, 0, 0), 0.0);
  RoverBody& rover = world.rover;
  const double I = model.left_wheel.I_LCom_L(1, 1), J = model.motors[0].reflected_inertia_kg_m2;
  for (int i = 0; i < 1000; ++i) {
    rover.AddJointTorque(RoverLink::kLeftWheel, 2.0);
    world.contacts.Step(kDt);
  }
  EXPECT_NEAR(rover.joint_rad_s(RoverLink::kLeftWheel), 2.0 / (I + J), 1e-6);
}

/// Peak force of the arm's tip that turns at 0.2 rad/s onto the face of a station that stands fast.
double PeakOfAnArmsBlow(double rotor_kg_m2, double step_s) {
  RoverModel model = Axel();
  model.motors[static_cast<int>(Motor::kArm)].reflected_inertia_kg_m2 = rotor_kg_m2;
  model.body.mass_kg = 1e9;
  model.body.I_LCom_L = 1e9 * Eigen::Matrix3d::Identity();
  StationModel heavy = Station();
  heavy.module.mass_kg = 1e9;
  heavy.module.I_LCom_L = 1e9 * Eigen::Matrix3d::Identity();
  heavy.tip_angle_rad = 0.0;
  heavy.cone.contact_damping_ns_per_m = 0.0;
  heavy.cone.face_friction = heavy.cone.funnel_friction = 0.0;
  // Hanging ahead of the face, its nose above the mouth, and swinging back against it.
  const double on_face =
      heavy.mouth_height_m + 0.5 * (heavy.cone.mouth_radius_m + heavy.cone.face_outer_radius_m);
  Afloat world(model, heavy, kWeightless,
               Pose3::Translation(0.035, 0.0, model.arm_length_m + on_face), 0.5 * kPi);
  world.rover.tree().AddSpeeds(0.2 * TreeBody::Speeds::Unit(9, 8));  // of the arm
  double peak = 0.0;
  for (long i = 0; i < std::lround(0.4 / step_s); ++i) {
    world.contacts.Step(step_s);
    peak = std::max(peak, world.contacts.arm_contact().total_G.norm());
  }
  return peak;
}

TEST(Rotors, GiveTheirMomentumToWhatTheArmStrikes) {
  // A spring's peak: w sqrt(k (I + J)), at the arm's length of 1 m. The nose's two rims strike at
  // once, 6 mm apart.
  const double arm = 0.33384 + 4.0 * 0.25;  // axel.urdf
  const double stiffness = 2.0 * Station().cone.contact_stiffness_n_per_m;
  for (double rotor : {0.1, 4.0}) {
    const double peak = PeakOfAnArmsBlow(rotor, 1e-5);
    EXPECT_NEAR(peak, 0.2 * std::sqrt(stiffness * (arm + rotor)), 0.01 * peak);
  }
}

TEST(Rotors, AreTheSameNearTheStationAsFarFromIt) {
  // Near it contacts are looked for.
  EXPECT_NEAR(EnergyError(1e-3, 1.8), EnergyError(1e-3, 50.0), 1e-9);
}

}  // namespace
}  // namespace dockyard::axel
