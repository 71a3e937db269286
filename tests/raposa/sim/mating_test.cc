// Robot and pyramid without weight, ground and cable: what their contacts alone do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "raposa/sim/raposa_rig.h"
#include "sim/raposa/mating_contacts.h"
#include "sim/raposa/mating_shapes.h"
#include "sim/raposa/pyramid_loads.h"

namespace dockyard::raposa {
namespace {

using Eigen::Vector3d;

constexpr double kDoor_n = 60.0;  // of each motor

/// The guide's middle off its seat, in the robot's frame; the guide along the socket's axis.
class Floating {
 public:
  Floating(const WorldSetup& setup, const Vector3d& off_seat_m, double step_s)
      : step_s_(step_s), mating_(setup.robot, setup.pyramid, true) {
    world_.Add(MakeRobot(setup.robot, {}));
    world_.Add(MakePyramid(
        setup.pyramid, {RotY(setup.pyramid.guide.up_rad), setup.robot.socket.p_RS + off_seat_m}));
  }

  void Step(double door_n) {
    world_.body(kRobot).AddJointTorque(kLeftDoor, -door_n);
    world_.body(kRobot).AddJointTorque(kRightDoor, door_n);
    mating_.Find(world_);
    world_.Step(step_s_);
  }
  /// So slowly that nothing is thrown.
  void CloseDoors() {
    const long steps = std::lround(2.0 / step_s_);
    for (long i = 0; i < steps; ++i) {
      Step(kDoor_n * std::min(1.0, static_cast<double>(2 * i) / static_cast<double>(steps)));
    }
  }
  RigidWorld& world() { return world_; }
  double energy_j() const {
    return world_.body(kRobot).KineticEnergy() + world_.body(kPyramid).KineticEnergy();
  }
  Vector3d momentum_kg_m_s(const RobotModel& robot, const PyramidModel& pyramid) const {
    const LinkModel* const models[] = {&robot.body, &robot.arm, &robot.left_door,
                                       &robot.right_door};
    Vector3d sum = pyramid.body.mass_kg * world_.body(kPyramid).speeds().head<3>();
    for (int i = 0; i < kRobotLinkCount; ++i) {
      const LinkMotion& motion = world_.body(kRobot).motion(i);
      sum += models[i]->mass_kg * motion.VelocityAt(motion.X_GL * models[i]->p_LoCom_L);
    }
    return sum;
  }
  /// Along the normals, by the robot's link.
  std::map<int, double> Forces() const {
    std::map<int, double> forces_n;
    for (const WorldContact& contact : world_.contacts()) {
      forces_n[contact.b.link] += contact.impulse_G.dot(contact.normal_G) / step_s_;
    }
    return forces_n;
  }
  Vector3d off_seat_m(const RobotModel& robot) const {
    return Inverse(world_.body(kRobot).motion(kBody).X_GL) *
               world_.body(kPyramid).motion(0).X_GL.p -
           robot.socket.p_RS;
  }

 private:
  double step_s_;
  RigidWorld world_{Vector3d::Zero()};
  MatingContacts mating_;
};

TEST(RaposaMating, DoorsDrawTheGuideIntoItsSeatWithTheSameForcesInAnyStep) {
  const WorldSetup setup = AtStart(1.0);
  std::vector<std::map<int, double>> forces_n;
  for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
    Floating floating(setup, {-3e-3, 0.3e-3, -0.3e-3}, step_s);
    floating.CloseDoors();
    EXPECT_LT(floating.off_seat_m(setup.robot).norm(), 0.3e-3) << step_s;
    forces_n.push_back(floating.Forces());
    std::printf("%g ms: seat %.2f, doors %.2f and %.2f N\n", 1e3 * step_s, forces_n.back()[kBody],
                forces_n.back()[kLeftDoor], forces_n.back()[kRightDoor]);
  }
  for (const RobotLink link : {kBody, kLeftDoor, kRightDoor}) {
    const double wanted_n = forces_n[0][link];
    EXPECT_GT(wanted_n, 0.5 * kDoor_n);
    for (std::map<int, double>& at : forces_n) EXPECT_NEAR(at[link], wanted_n, 0.03 * wanted_n);
  }
}

TEST(RaposaMating, GuideHeldByTheDoorsComesToRest) {
  const WorldSetup setup = AtStart(1.0);
  Floating floating(setup, {-3e-3, 0.3e-3, -0.3e-3}, 1e-3);
  floating.CloseDoors();
  double fastest_j = 0.0;
  for (int i = 0; i < 500; ++i) {
    floating.Step(kDoor_n);
    fastest_j = std::max(fastest_j, floating.energy_j());
  }
  EXPECT_LT(fastest_j, 1e-9);  // of 0.6 kg: 0.06 mm/s
}

TEST(RaposaMating, BlowsKeepMomentumAndTakeEnergy) {
  const WorldSetup setup = AtStart(1.0);
  for (const double step_s : {0.5e-3, 1e-3, 2e-3}) {
    Floating floating(setup, {-0.02, 2e-3, 3e-3}, step_s);
    TreeBody::Speeds thrown = TreeBody::Speeds::Zero(6);
    thrown.head<3>() = Vector3d(0.2, 0.01, -0.02);
    floating.world().body(kPyramid).AddSpeeds(thrown);
    const Vector3d before = floating.momentum_kg_m_s(setup.robot, setup.pyramid);
    const double first_j = floating.energy_j();
    double most_j = 0.0, touched_n = 0.0;
    for (long i = 0; i < std::lround(2.0 / step_s); ++i) {
      floating.Step(0.0);
      most_j = std::max(most_j, floating.energy_j());
      for (const auto& [link, force_n] : floating.Forces()) {
        touched_n = std::max(touched_n, force_n);
      }
    }
    EXPECT_GT(touched_n, 10.0);
    EXPECT_LT(most_j, first_j * (1.0 + 1e-6)) << step_s;
    EXPECT_LT(floating.energy_j(), 0.9 * first_j) << step_s;
    // The robot's arm and doors turn with it, to the step's order.
    EXPECT_LT((floating.momentum_kg_m_s(setup.robot, setup.pyramid) - before).norm(),
              5e-6 * before.norm());
  }
}

// A rotor does not turn with the robot, so the inertia of the body's speeds is that of the links.
TEST(RaposaMating, RotorsResistTheirJointsAlone) {
  const WorldSetup setup = AtStart(1.0);
  RobotModel without = setup.robot;
  for (MotorModel& motor : without.motors) motor.reflected_inertia_kg_m2 = 0.0;
  const TreeBody robot = MakeRobot(setup.robot, {}), plain = MakeRobot(without, {});
  TreeBody::Inertia more = robot.MassMatrix() - plain.MassMatrix();
  const double radius_m = setup.robot.doors.pinion_radius_m;
  EXPECT_NEAR(more(6, 6), setup.robot.motors[2].reflected_inertia_kg_m2, 1e-12);
  for (const int door : {7, 8}) {
    EXPECT_NEAR(more(door, door),
                setup.robot.motors[3].reflected_inertia_kg_m2 / (radius_m * radius_m), 1e-12);
  }
  more.diagonal().tail<3>().setZero();
  EXPECT_LT(more.norm(), 1e-12);
}

// Beyond its travel a door rests on the stop's spring, less what the gear's friction may hold.
TEST(RaposaMating, StopHoldsADoorAgainstItsMotor) {
  const WorldSetup setup = AtStart(1.0);
  const DoorsModel& doors = setup.robot.doors;
  const MotorModel& motor = setup.robot.motors[3];
  World world(setup);
  MotorCommands open{};
  open[3] = raposa::Run(setup, Motor::kLeftDoor, -0.5);
  open[4] = raposa::Run(setup, Motor::kRightDoor, -0.5);
  Play(world, setup, open, 3.0);
  const double push_n = motor.torque_per_amp_nm * (motor.max_current_a - motor.no_load_current_a) /
                        doors.pinion_radius_m;
  const double gear_n = motor.gear_friction_nm / doors.pinion_radius_m;
  constexpr double kStop_n_per_m = 1e5;
  const Truth truth = world.truth();
  for (const double at_m : {truth.left_door_m, truth.right_door_m}) {
    EXPECT_NEAR(at_m - doors.travel_m, push_n / kStop_n_per_m, 1.01 * gear_n / kStop_n_per_m);
  }
}

}  // namespace
}  // namespace dockyard::raposa
