#include "sim/raposa/world.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/raposa/mating_contacts.h"
#include "sim/raposa/pyramid_loads.h"
#include "sim/raposa/robot_links.h"
#include "sim/raposa/tracks.h"

namespace dockyard::raposa {
namespace {

// Robot and pyramid come to rest, and the cable lets out its slack, before the run begins. Assumed,
// 1-3 s.
constexpr double kSettleSeconds = 1.5;
// Where sweeps of contacts end: impulses are good to 0.1 %. Numerical, 1e-7 to 1e-5.
constexpr double kSolvedTo = 1e-5;

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

const MotorModel& ModelOf(const RobotModel& robot, Motor motor) {
  return robot.motors[static_cast<std::size_t>(motor)];
}

/// Inertia that the arm's drive turns: its rotor, and arm and body against each other.
double ArmInertia(const RobotModel& robot) {
  const Eigen::Vector3d& c = robot.arm.p_LoCom_L;
  const double own = robot.arm.I_LCom_L(1, 1) + robot.arm.mass_kg * c.squaredNorm();
  const double body = robot.body.I_LCom_L(1, 1);
  return ModelOf(robot, Motor::kArm).reflected_inertia_kg_m2 + own * body / (own + body);
}

double DoorInertia(const RobotModel& robot) {
  const double r = robot.doors.pinion_radius_m;
  return ModelOf(robot, Motor::kLeftDoor).reflected_inertia_kg_m2 + robot.left_door.mass_kg * r * r;
}

RigidWorld MakeWorld(const WorldSetup& setup) {
  RigidWorld world(GravityInSite(setup.slope));
  world.SetSolved(kSolvedTo);
  world.Add(MakeRobot(setup.robot, RobotStart(setup)));
  world.Add(MakePyramid(setup.pyramid, PyramidStart(setup)));
  const RobotModel& robot = setup.robot;
  const DoorsModel& doors = robot.doors;
  world.Limit({kRobot, kArm}, StopsAt(robot.arm_stop, robot.arm_lower_rad, robot.arm_upper_rad));
  world.Limit({kRobot, kLeftDoor}, StopsAt(doors.stop, 0.0, doors.travel_m));
  world.Limit({kRobot, kRightDoor}, StopsAt(doors.stop, -doors.travel_m, 0.0));
  return world;
}

}  // namespace

class World::Impl {
 public:
  explicit Impl(const WorldSetup& setup);

  void Step(const std::array<MotorCommand, kMotorCount>& commands);
  Truth MakeTruth() const;
  TrueImu TakeTrueImu() { return imu_.Take(robot().motion(kBody), X_WG_); }
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
      {{kLeftDoor, Motor::kLeftDoor, 1.0}, {kRightDoor, Motor::kRightDoor, -1.0}}};

  double time_s() const { return static_cast<double>(steps_) * setup_.step_s; }
  const TreeBody& robot() const { return world_.body(kRobot); }
  TreeBody& robot() { return world_.body(kRobot); }
  const LinkMotion& pyramid() const { return world_.body(kPyramid).motion(0); }
  double ArmAngle() const { return robot().angle_rad(kArm); }
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
  RigidWorld world_;
  PyramidLoads pyramid_loads_;
  MatingContacts mating_;
  Tracks tracks_;
  MotorDrive arm_drive_;
  std::array<MotorDrive, 2> door_drives_;
  DriveOutput arm_output_;
  std::array<DriveOutput, 2> door_output_;
  Pose3 X_GP_start_;
  double contact_n_ = 0.0, contact_peak_n_ = 0.0;
  long steps_ = 0;
};

World::Impl::Impl(const WorldSetup& setup)
    : setup_(setup),
      X_WG_(SiteInWorld(setup.X_WG, setup.slope)),
      gravity_G_(GravityInSite(setup.slope)),
      imu_(setup.robot.imu.value_or(ImuModel{}), gravity_G_),
      world_(MakeWorld(setup)),
      pyramid_loads_(setup.pyramid, PyramidStart(setup), CableFarEnd(setup), SoilsOf(setup)),
      mating_(setup.robot, setup.pyramid, setup.search_always),
      tracks_(setup.robot, setup.grounds, setup.seed),
      arm_drive_(ModelOf(setup.robot, Motor::kArm), ArmInertia(setup.robot)),
      door_drives_{MotorDrive(ModelOf(setup.robot, Motor::kLeftDoor), DoorInertia(setup.robot)),
                   MotorDrive(ModelOf(setup.robot, Motor::kRightDoor), DoorInertia(setup.robot))} {
  DOCKYARD_CHECK(setup.step_s > 0.0 && setup.step_s <= 5e-3);
  const std::array<MotorCommand, kMotorCount> braked{};
  const long settle = std::lround(kSettleSeconds / setup.step_s);
  for (long i = 0; i < settle; ++i) Step(braked);
  steps_ = 0;
  tracks_.PowerOn();
  contact_peak_n_ = 0.0;
  X_GP_start_ = pyramid().X_GL;
  imu_.Start(robot().motion(kBody));
}

double World::Impl::DoorAngle(const DoorDrive& door) const {
  const DoorsModel& doors = setup_.robot.doors;
  return (doors.travel_m - door.side * robot().angle_rad(door.link)) / doors.pinion_radius_m;
}

double World::Impl::DoorRate(const DoorDrive& door) const {
  return -door.side * robot().rate_rad_s(door.link) / setup_.robot.doors.pinion_radius_m;
}

void World::Impl::DriveArm(const MotorCommand& command) {
  arm_output_ = arm_drive_.Step(command, ArmAngle(), robot().rate_rad_s(kArm), setup_.step_s);
  robot().AddJointTorque(kArm, arm_output_.torque_nm());
}

void World::Impl::DriveDoor(const DoorDrive& door, const MotorCommand& command) {
  const std::size_t place = door.side > 0.0 ? 0 : 1;
  door_output_[place] =
      door_drives_[place].Step(command, DoorAngle(door), DoorRate(door), setup_.step_s);
  robot().AddJointTorque(
      door.link, -door.side * door_output_[place].torque_nm() / setup_.robot.doors.pinion_radius_m);
}

void World::Impl::Step(const std::array<MotorCommand, kMotorCount>& commands) {
  const auto command = [&](Motor motor) { return commands[static_cast<std::size_t>(motor)]; };
  tracks_.Step(setup_.ground, {command(Motor::kLeftBelt), command(Motor::kRightBelt)},
               setup_.step_s, robot());
  DriveArm(command(Motor::kArm));
  for (const DoorDrive& door : kDoors) DriveDoor(door, command(door.motor));
  pyramid_loads_.AddTo(world_.body(kPyramid), setup_.ground, gravity_G_, setup_.step_s);
  mating_.Find(world_);
  world_.Step(setup_.step_s);
  imu_.Add(robot().motion(kBody), setup_.step_s);
  contact_n_ = 0.0;
  for (const WorldContact& contact : world_.contacts()) {
    contact_n_ += contact.impulse_G.dot(contact.normal_G) / setup_.step_s;
  }
  contact_peak_n_ = std::max(contact_peak_n_, contact_n_);
  ++steps_;
}

Eigen::Vector3d World::Impl::GuideFromSeat() const {
  const Pose3& X_GR = robot().motion(kBody).X_GL;
  return Inverse(X_GR) * pyramid().X_GL.p - setup_.robot.socket.p_RS;
}

Truth World::Impl::MakeTruth() const {
  Truth truth;
  truth.time_s = time_s();
  const LinkMotion& body = robot().motion(kBody);
  truth.X_WR = X_WG_ * body.X_GL;
  truth.X_WA = X_WG_ * robot().motion(kArm).X_GL;
  truth.X_W_left_door = X_WG_ * robot().motion(kLeftDoor).X_GL;
  truth.X_W_right_door = X_WG_ * robot().motion(kRightDoor).X_GL;
  truth.X_WP = X_WG_ * pyramid().X_GL;
  truth.v_WR_W = X_WG_.R * body.v_GL_G;
  truth.w_WR_W = X_WG_.R * body.w_GL_G;
  truth.X_DR_start = Inverse(FromGround(setup_.X_GD, 0.0)) * body.X_GL;
  truth.X_PR = Inverse(pyramid().X_GL) * body.X_GL;
  const Eigen::Vector3d p_PC = truth.X_PR * setup_.robot.camera.X_RC.p;
  truth.range_m = std::hypot(p_PC.x(), p_PC.y());
  truth.alpha_rad = std::atan2(p_PC.y(), p_PC.x());
  truth.p_SP_R = GuideFromSeat();
  truth.arm_rad = ArmAngle();
  truth.left_door_m = robot().angle_rad(kLeftDoor);
  truth.right_door_m = -robot().angle_rad(kRightDoor);
  const auto tell = [&](Motor motor, double angle, double speed, const DriveOutput& output) {
    truth.motors[static_cast<std::size_t>(motor)] = {angle, speed, output.torque_nm(),
                                                     output.current_a, output.lead_rad};
  };
  tell(Motor::kLeftBelt, tracks_.read_rad(Side::kLeft), tracks_.speed_rad_s(Side::kLeft),
       tracks_.output(Side::kLeft));
  tell(Motor::kRightBelt, tracks_.read_rad(Side::kRight), tracks_.speed_rad_s(Side::kRight),
       tracks_.output(Side::kRight));
  tell(Motor::kArm, ArmAngle(), robot().rate_rad_s(kArm), arm_output_);
  for (const DoorDrive& door : kDoors) {
    tell(door.motor, DoorAngle(door), DoorRate(door), door_output_[door.side > 0.0 ? 0 : 1]);
  }
  truth.contact_n = contact_n_;
  truth.contact_peak_n = contact_peak_n_;
  const Pose3 X_start_now = Inverse(X_GP_start_) * pyramid().X_GL;
  truth.pyramid_shift_m = std::hypot(X_start_now.p.x(), X_start_now.p.y());
  truth.pyramid_turn_rad = std::atan2(X_start_now.R(1, 0), X_start_now.R(0, 0));
  truth.pyramid_tilt_rad = std::acos(std::clamp(X_start_now.R(2, 2), -1.0, 1.0));
  truth.cable_pull_n = pyramid_loads_.cable_pull_n();
  for (const Eigen::Vector3d& p_G : pyramid_loads_.CableLine(pyramid().X_GL))
    truth.cable_W.push_back(X_WG_ * p_G);
  return truth;
}

std::uint64_t World::Impl::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(steps_));
  hash = world_.StateHash(hash);
  hash = pyramid_loads_.StateHash(hash);
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
