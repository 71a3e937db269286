#include "sim/raposa/world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/drives/joint_stop.h"
#include "sim/raposa/bullet_world.h"
#include "sim/raposa/pyramid_body.h"
#include "sim/raposa/robot_body.h"
#include "sim/raposa/tracks.h"

namespace dockyard::raposa {
namespace {

// Robot and pyramid come to rest, and the cable lets out its slack, before the run begins. Assumed,
// 1-3 s.
constexpr double kSettleSeconds = 1.5;
// End stops of arm and doors: a tenth of a millimetre at the motors' limits, a fifth of critical or
// more on what they stop. Assumed: 1e4-1e6 N m/rad and N/m, 20-100 N m s/rad, 5-50 N s/m.
constexpr JointStop kArmStop{2e4, 50.0}, kDoorStop{1e5, 20.0};

/// The body on its main belts, so that the camera is where it is told in plan.
Pose3 RobotStart(const WorldSetup& setup) {
  const Pose2 X_GV = setup.X_GD * setup.X_DV_start;
  const double heading = X_GV.heading + kPi;  // the camera looks back
  const Eigen::Vector2d to_camera =
      Eigen::Rotation2Dd(heading) * setup.robot.camera.X_RC.p.head<2>();
  const Pose2 X_GR{X_GV.x - to_camera.x(), X_GV.y - to_camera.y(), heading};
  return FromGround(X_GR, setup.ground.Height(X_GR.x, X_GR.y) + setup.robot.belts.roller_radius_m);
}

Pose3 PyramidStart(const WorldSetup& setup) {
  return FromGround(setup.X_GD,
                    setup.ground.Height(setup.X_GD.x, setup.X_GD.y) + setup.pyramid.guide.height_m);
}

std::vector<std::optional<SoilModel>> SoilsOf(const WorldSetup& setup) {
  std::vector<std::optional<SoilModel>> soils;
  for (const GroundModel& ground : setup.grounds) soils.push_back(ground.soil);
  return soils;
}

Eigen::Vector3d CableFarEnd(const WorldSetup& setup) {
  const TetherCableModel& cable = setup.pyramid.cable;
  const double way_m = cable.length_m - cable.slack_m;
  const double back = setup.X_GD.heading + kPi + setup.cable_rad;
  const Eigen::Vector2d p = Eigen::Vector2d(setup.X_GD.x, setup.X_GD.y) +
                            way_m * Eigen::Vector2d(std::cos(back), std::sin(back));
  return {p.x(), p.y(), setup.ground.Height(p.x(), p.y()) + 0.5 * cable.diameter_m};
}

/// Rotors count as parts of what they move. The arm's then resists the body's pitch as well, by a
/// third of the robot's own inertia: pitching is slower than it should be, and rests at the same
/// angles. The doors' masses are taken from the body's, at its centre of mass.
WorldSetup WithRotors(WorldSetup setup) {
  RobotModel& robot = setup.robot;
  const auto rotor_kg_m2 = [&](Motor motor) {
    return robot.motors[static_cast<std::size_t>(motor)].reflected_inertia_kg_m2;
  };
  robot.arm.I_LCom_L(1, 1) += rotor_kg_m2(Motor::kArm);
  const double radius_m = robot.doors.pinion_radius_m;
  for (const auto& [door, motor] : {std::pair(&robot.left_door, Motor::kLeftDoor),
                                    std::pair(&robot.right_door, Motor::kRightDoor)}) {
    const double rotor_kg = rotor_kg_m2(motor) / (radius_m * radius_m);
    const double share = rotor_kg / (door->mass_kg + rotor_kg);
    Eigen::Vector3d to_body = robot.body.p_LoCom_L - robot.p_R_doors - door->p_LoCom_L;
    to_body.y() = 0.0;
    door->p_LoCom_L += share * to_body;
    door->mass_kg += rotor_kg;
    robot.body.mass_kg -= rotor_kg;
  }
  return setup;
}

/// Inertia that the arm's drive turns: arm, with its rotor, and body against each other.
double ArmInertia(const RobotModel& robot) {
  const Eigen::Vector3d& c = robot.arm.p_LoCom_L;
  const double own = robot.arm.I_LCom_L(1, 1) + robot.arm.mass_kg * c.squaredNorm();
  const double body = robot.body.I_LCom_L(1, 1);
  return own * body / (own + body);
}

double DoorInertia(const RobotModel& robot) {
  const double r = robot.doors.pinion_radius_m;
  return robot.left_door.mass_kg * r * r;
}

const MotorModel& ModelOf(const RobotModel& robot, Motor motor) {
  return robot.motors[static_cast<std::size_t>(motor)];
}

}  // namespace

class World::Impl {
 public:
  explicit Impl(const WorldSetup& setup);

  void Step(const std::array<MotorCommand, kMotorCount>& commands);
  Truth MakeTruth() const;
  TrueImu TakeTrueImu() { return imu_.Take(robot_.motion(RobotLink::kBody), X_WG_); }
  Tick tick() const { return std::llround(time_s() / kTickSeconds); }
  const HeightGrid& ground() const { return setup_.ground; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct DoorDrive {
    RobotLink link;
    Motor motor;
    double side;  // of its travel
  };
  static constexpr std::array<DoorDrive, 2> kDoors{
      {{RobotLink::kLeftDoor, Motor::kLeftDoor, 1.0},
       {RobotLink::kRightDoor, Motor::kRightDoor, -1.0}}};

  double time_s() const { return static_cast<double>(steps_) * setup_.step_s; }
  double ArmAngle() const { return robot_.joint(RobotLink::kArm); }
  /// A door's motor, closing positive, from open.
  double DoorAngle(const DoorDrive& door) const;
  double DoorRate(const DoorDrive& door) const;
  void DriveArm(const MotorCommand& command);
  void DriveDoor(const DoorDrive& door, const MotorCommand& command);
  Eigen::Vector3d GuideFromSeat() const;

  WorldSetup setup_;
  Pose3 X_WG_;
  Eigen::Vector3d gravity_G_;
  ImuAverage imu_;
  RobotBody robot_;
  PyramidBody pyramid_;
  BulletWorld bullet_;
  Tracks tracks_;
  MotorDrive arm_drive_;
  std::array<MotorDrive, 2> door_drives_;
  DriveOutput arm_output_;
  std::array<DriveOutput, 2> door_output_;
  Pose3 X_GP_start_;
  double contact_peak_n_ = 0.0;
  long steps_ = 0;
};

World::Impl::Impl(const WorldSetup& setup)
    : setup_(WithRotors(setup)),
      X_WG_(SiteInWorld(setup.X_WG, setup.slope)),
      gravity_G_(GravityInSite(setup.slope)),
      imu_(setup.robot.imu.value_or(ImuModel{}), gravity_G_),
      robot_(setup_.robot, RobotStart(setup), 0.0),
      pyramid_(setup.pyramid, PyramidStart(setup), CableFarEnd(setup), SoilsOf(setup)),
      bullet_(robot_, pyramid_, setup_.robot, setup_.pyramid, gravity_G_, setup.search_always),
      tracks_(setup.robot, setup.grounds, setup.seed),
      arm_drive_(ModelOf(setup.robot, Motor::kArm), ArmInertia(setup_.robot)),
      door_drives_{MotorDrive(ModelOf(setup.robot, Motor::kLeftDoor), DoorInertia(setup_.robot)),
                   MotorDrive(ModelOf(setup.robot, Motor::kRightDoor), DoorInertia(setup_.robot))} {
  DOCKYARD_CHECK(setup.step_s > 0.0 && setup.step_s <= 5e-3);
  const std::array<MotorCommand, kMotorCount> braked{};
  const long settle = std::lround(kSettleSeconds / setup.step_s);
  for (long i = 0; i < settle; ++i) Step(braked);
  steps_ = 0;
  tracks_.PowerOn();
  contact_peak_n_ = 0.0;
  X_GP_start_ = pyramid_.motion().X_GL;
  imu_.Start(robot_.motion(RobotLink::kBody));
}

double World::Impl::DoorAngle(const DoorDrive& door) const {
  const DoorsModel& doors = setup_.robot.doors;
  return (doors.travel_m - door.side * robot_.joint(door.link)) / doors.pinion_radius_m;
}

double World::Impl::DoorRate(const DoorDrive& door) const {
  return -door.side * robot_.joint_rate(door.link) / setup_.robot.doors.pinion_radius_m;
}

void World::Impl::DriveArm(const MotorCommand& command) {
  const double rate = robot_.joint_rate(RobotLink::kArm);
  arm_output_ = arm_drive_.Step(command, ArmAngle(), rate, setup_.step_s);
  const double stop_nm =
      kArmStop.Load(ArmAngle(), rate, setup_.robot.arm_lower_rad, setup_.robot.arm_upper_rad);
  robot_.AddJointLoad(RobotLink::kArm, arm_output_.torque_nm() + stop_nm);
}

void World::Impl::DriveDoor(const DoorDrive& door, const MotorCommand& command) {
  const DoorsModel& doors = setup_.robot.doors;
  DriveOutput& output = door_output_[door.side > 0.0 ? 0 : 1];
  output = door_drives_[door.side > 0.0 ? 0 : 1].Step(command, DoorAngle(door), DoorRate(door),
                                                      setup_.step_s);
  const double stop_n =
      kDoorStop.Load(door.side * robot_.joint(door.link), door.side * robot_.joint_rate(door.link),
                     0.0, doors.travel_m);
  robot_.AddJointLoad(door.link, door.side * (stop_n - output.torque_nm() / doors.pinion_radius_m));
}

void World::Impl::Step(const std::array<MotorCommand, kMotorCount>& commands) {
  const auto command = [&](Motor motor) { return commands[static_cast<std::size_t>(motor)]; };
  tracks_.Step(setup_.ground, {command(Motor::kLeftBelt), command(Motor::kRightBelt)},
               setup_.step_s, robot_);
  DriveArm(command(Motor::kArm));
  for (const DoorDrive& door : kDoors) DriveDoor(door, command(door.motor));
  pyramid_.AddForces(setup_.ground, gravity_G_, setup_.step_s);
  bullet_.Step(setup_.step_s);
  robot_.Refresh();
  pyramid_.Refresh();
  imu_.Add(robot_.motion(RobotLink::kBody), setup_.step_s);
  contact_peak_n_ = std::max(contact_peak_n_, bullet_.contact_n());
  ++steps_;
}

Eigen::Vector3d World::Impl::GuideFromSeat() const {
  const Pose3& X_GR = robot_.motion(RobotLink::kBody).X_GL;
  return Inverse(X_GR) * pyramid_.motion().X_GL.p - setup_.robot.socket.p_RS;
}

Truth World::Impl::MakeTruth() const {
  Truth truth;
  truth.time_s = time_s();
  const LinkMotion& body = robot_.motion(RobotLink::kBody);
  const LinkMotion& pyramid = pyramid_.motion();
  truth.X_WR = X_WG_ * body.X_GL;
  truth.X_WA = X_WG_ * robot_.motion(RobotLink::kArm).X_GL;
  truth.X_W_left_door = X_WG_ * robot_.motion(RobotLink::kLeftDoor).X_GL;
  truth.X_W_right_door = X_WG_ * robot_.motion(RobotLink::kRightDoor).X_GL;
  truth.X_WP = X_WG_ * pyramid.X_GL;
  truth.v_WR_W = X_WG_.R * body.v_GL_G;
  truth.w_WR_W = X_WG_.R * body.w_GL_G;
  truth.X_DR_start = Inverse(FromGround(setup_.X_GD, 0.0)) * body.X_GL;
  truth.X_PR = Inverse(pyramid.X_GL) * body.X_GL;
  const Eigen::Vector3d p_PC = truth.X_PR * setup_.robot.camera.X_RC.p;
  truth.range_m = std::hypot(p_PC.x(), p_PC.y());
  truth.alpha_rad = std::atan2(p_PC.y(), p_PC.x());
  truth.p_SP_R = GuideFromSeat();
  truth.arm_rad = ArmAngle();
  truth.left_door_m = robot_.joint(RobotLink::kLeftDoor);
  truth.right_door_m = -robot_.joint(RobotLink::kRightDoor);
  const auto tell = [&](Motor motor, double angle, double speed, const DriveOutput& output) {
    truth.motors[static_cast<std::size_t>(motor)] = {angle, speed, output.torque_nm(),
                                                     output.current_a, output.lead_rad};
  };
  tell(Motor::kLeftBelt, tracks_.read_rad(Side::kLeft), tracks_.speed_rad_s(Side::kLeft),
       tracks_.output(Side::kLeft));
  tell(Motor::kRightBelt, tracks_.read_rad(Side::kRight), tracks_.speed_rad_s(Side::kRight),
       tracks_.output(Side::kRight));
  tell(Motor::kArm, ArmAngle(), robot_.joint_rate(RobotLink::kArm), arm_output_);
  for (const DoorDrive& door : kDoors) {
    tell(door.motor, DoorAngle(door), DoorRate(door), door_output_[door.side > 0.0 ? 0 : 1]);
  }
  truth.contact_n = bullet_.contact_n();
  truth.contact_peak_n = contact_peak_n_;
  const Pose3 X_start_now = Inverse(X_GP_start_) * pyramid.X_GL;
  truth.pyramid_shift_m = std::hypot(X_start_now.p.x(), X_start_now.p.y());
  truth.pyramid_turn_rad = std::atan2(X_start_now.R(1, 0), X_start_now.R(0, 0));
  truth.pyramid_tilt_rad = std::acos(std::clamp(X_start_now.R(2, 2), -1.0, 1.0));
  truth.cable_pull_n = pyramid_.cable_pull_n();
  for (const Eigen::Vector3d& p_G : pyramid_.CableLine()) truth.cable_W.push_back(X_WG_ * p_G);
  return truth;
}

std::uint64_t World::Impl::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(steps_));
  hash = robot_.StateHash(hash);
  hash = pyramid_.StateHash(hash);
  hash = tracks_.StateHash(hash);
  hash = arm_drive_.StateHash(hash);
  for (const MotorDrive& drive : door_drives_) hash = drive.StateHash(hash);
  return hash;
}

World::World(const WorldSetup& setup) : impl_(std::make_unique<Impl>(setup)) {}
World::~World() = default;
void World::Step(const std::array<MotorCommand, kMotorCount>& commands) { impl_->Step(commands); }
Tick World::tick() const { return impl_->tick(); }
Truth World::truth() const { return impl_->MakeTruth(); }
TrueImu World::TakeTrueImu() { return impl_->TakeTrueImu(); }
const HeightGrid& World::ground() const { return impl_->ground(); }
std::uint64_t World::StateHash(std::uint64_t seed) const { return impl_->StateHash(seed); }

}  // namespace dockyard::raposa
