// The rigid bodies against closed forms: fall, rolling, free tumbling.
#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/afloat.h"
#include "sim/soil/wheel_soil.h"

namespace dockyard::axel {
namespace {

/// Error of the way fallen in a second against g t^2 / 2.
double FallError(double step_s) {
  Afloat world(9.81);
  const double z0 = world.rover.motion(RoverLink::kBody).X_GL.p.z();
  for (long i = 0; i < std::lround(1.0 / step_s); ++i) world.contacts.Step(step_s);
  return z0 - world.rover.motion(RoverLink::kBody).X_GL.p.z() - 0.5 * 9.81;
}

TEST(ClosedForm, FreeFallErrsByHalfGTimesTheStep) {
  // Semi-implicit Euler: x = g t (t + dt) / 2, to the last bits.
  for (double step : {2e-3, 1e-3, 0.5e-3}) {
    EXPECT_NEAR(FallError(step), 0.5 * 9.81 * step, 1e-9);
  }
}

/// A rover with smooth wheels, balanced on its axle, without friction in its gears, on elastic
/// ground that does not yield; gravity leans forward as on a slope.
struct Rolling {
  double v_m_s = 0.0, way_m = 0.0, pitch_rad = 0.0;
};
Rolling RollDown(double slope_rad, double seconds) {
  RoverModel model = Axel();
  model.body.p_LoCom_L.setZero();
  model.arm.p_LoCom_L.setZero();
  for (MotorModel& motor : model.motors) motor.reflected_inertia_kg_m2 = 1e-9;
  for (WheelModel* wheel : {&model.left_wheel_soil, &model.right_wheel_soil}) {
    *wheel = {.rim_radius_m = 0.3, .width_m = 0.15};
  }
  SoilModel hard;
  hard.k_phi = 1e13;
  hard.friction_angle_rad = 0.6;
  hard.shear_modulus_m = 5e-4;
  hard.shear_depth_m = kLeastDepth_m;
  hard.unloading_stiffness_pa_per_m = 2e8;
  hard.damping_pa_s_per_m = 1e4;
  HeightGrid ground = LevelGrid(-1.0, 8.0, 4.0, 0.05);
  Afloat world(model, Station(), kWeightless, Pose3::Translation(0.0, 0.0, 0.2997), 0.0,
               Pose3::Translation(-50.0, 0.0, 0.0));
  RoverBody& rover = world.rover;
  WheelSoil left(model.left_wheel_soil, hard), right(model.right_wheel_soil, hard);
  for (long i = 0; i < std::lround(seconds * 1e3); ++i) {
    for (RoverLink link : kAllLinks) {
      const Eigen::Vector3d g(9.81 * std::sin(slope_rad), 0.0, -9.81 * std::cos(slope_rad));
      rover.AddForce(link, LinkOf(model, link).mass_kg * g, rover.CentreOfMass(link));
    }
    for (RoverLink link : {RoverLink::kLeftWheel, RoverLink::kRightWheel}) {
      const LinkMotion& motion = rover.motion(link);
      const WheelLoad load = (link == RoverLink::kLeftWheel ? left : right)
                                 .Step(ground, {motion.X_GL, motion.v_GL_G, motion.w_GL_G}, 1e-3);
      rover.AddForce(link, load.force_G, motion.X_GL.p);
      rover.AddTorque(link, load.torque_G);
    }
    world.contacts.Step(1e-3);
  }
  const LinkMotion& body = rover.motion(RoverLink::kBody);
  return {body.v_GL_G.x(), body.X_GL.p.x(), ToRollPitchYaw(body.X_GL.R).pitch};
}

TEST(ClosedForm, WheelsRollDownASlopeAsRollingInertiaSays) {
  // a = g sin / (1 + 2 I / (m R^2)); for a sphere the bracket is 7/5.
  const RoverModel model = Axel();
  const double R = 0.3, seconds = 2.0, slope = Radians(15.0);
  const double a = 9.81 * std::sin(slope) /
                   (1.0 + 2.0 * model.left_wheel.I_LCom_L(1, 1) / (model.mass_kg() * R * R));
  const Rolling rolled = RollDown(slope, seconds);
  EXPECT_NEAR(rolled.v_m_s, a * seconds, 0.01 * a * seconds);
  EXPECT_NEAR(rolled.way_m, 0.5 * a * seconds * seconds, 0.01 * 0.5 * a * seconds * seconds);
  EXPECT_NEAR(rolled.pitch_rad, 0.0, 1e-6);  // nothing turns the body
}

/// The largest relative changes of energy and momentum of a body that tumbles freely for ten
/// seconds.
struct Drift {
  double energy = 0.0, momentum = 0.0;
};
Drift Tumble(double step_s) {
  StationModel model = Station();
  model.tip_angle_rad = 0.0;
  model.module.mass_kg = 10.0;
  model.module.I_LCom_L = Eigen::Vector3d(0.5, 1.0, 1.4).asDiagonal();
  Afloat world(Axel(), model, kWeightless, Pose3::Translation(50.0, 0.0, 0.0), 0.0);
  StationBody& station = world.station;
  TreeBody::Speeds start(6);
  start << 0.0, 0.0, 0.0, 0.3, 2.0, 0.4;  // about the middle axis, nearly
  station.tree().AddSpeeds(start);
  const auto Measure = [&] {
    const LinkMotion& motion = station.motion();
    const Eigen::Vector3d w = motion.X_GL.R.transpose() * motion.w_GL_G;
    const Eigen::Vector3d L = model.module.I_LCom_L * w;
    return Eigen::Vector2d(0.5 * w.dot(L), L.norm());
  };
  const Eigen::Vector2d before = Measure();
  Eigen::Vector2d most(0.0, 0.0);
  for (long i = 0; i < std::lround(10.0 / step_s); ++i) {
    world.contacts.Step(step_s);
    most = most.cwiseMax((Measure() - before).cwiseQuotient(before).cwiseAbs());
  }
  return {most.x(), most.y()};
}

TEST(ClosedForm, TumblingBodyKeepsItsMomentumAndItsEnergyToTheStepsSecondOrder) {
  const Drift coarse = Tumble(2e-3), fine = Tumble(1e-3);
  EXPECT_LT(fine.energy, 1e-6);
  EXPECT_LT(fine.momentum, 1e-11);
  EXPECT_NEAR(coarse.energy / fine.energy, 4.0, 0.2);
}

/// The same of the whole rover, joints free.
Drift TumbleRover(double step_s) {
  Afloat world(0.0);
  TreeBody::Speeds start(9);
  start << 0.0, 0.0, 0.0, 0.2, 0.4, 0.9, 0.0, 0.0, 0.5;
  world.rover.tree().AddSpeeds(start);
  const auto Energy = [&] {
    double sum = 0.0;
    for (RoverLink link : kAllLinks) {
      const LinkModel& model = LinkOf(world.model, link);
      const LinkMotion& motion = world.rover.motion(link);
      const Eigen::Vector3d w = motion.X_GL.R.transpose() * motion.w_GL_G;
      const Eigen::Vector3d v = motion.VelocityAt(motion.X_GL * model.p_LoCom_L);
      sum += 0.5 * model.mass_kg * v.squaredNorm() + 0.5 * w.dot(model.I_LCom_L * w);
      if (link == RoverLink::kBody) continue;
      const double q = world.rover.joint_rad_s(link);
      sum += 0.5 * world.model.motors[static_cast<int>(link) - 1].reflected_inertia_kg_m2 * q * q;
    }
    return sum;
  };
  const double before = Energy();
  for (long i = 0; i < std::lround(4.0 / step_s); ++i) world.contacts.Step(step_s);
  return {Energy() / before - 1.0, 0.0};
}

TEST(ClosedForm, TumblingRoverKeepsItsEnergyToTheStepsFirstOrder) {
  const double coarse = TumbleRover(2e-3).energy, fine = TumbleRover(1e-3).energy;
  EXPECT_LT(std::abs(fine), 1e-2);
  EXPECT_NEAR(coarse / fine, 2.0, 0.3);
}

}  // namespace
}  // namespace dockyard::axel
