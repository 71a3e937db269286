#include "sim/custom/world.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/custom/range_beams.h"
#include "sim/custom/world_contacts.h"

namespace dockyard::custom {
namespace {

// The robot is put down with its lowest wheel on the ground, and comes to rest within this time.
// Assumed, 0.5-3 s.
constexpr double kSettle_s = 1.0;
// Of contacts: 1e-5 of the largest impulse is a fraction of a newton second's thousandth. Measured:
// the closed forms of tests/custom hold with it.
constexpr double kSolvedHere = 1e-5;
// A dock that nothing touches and that moves no faster for so long rests until it is touched.
constexpr double kStill_m_s = 1e-4, kStill_s = 0.2;  // assumed, 1e-5-1e-3 and 0.1-1

std::vector<CommandedJoint> JointsOf(const RobotModel& robot) {
  std::vector<CommandedJoint> joints;
  for (const MotorFit& motor : robot.motors) {
    const double travel = motor.travel_per_rad;
    joints.push_back({motor.link, motor.model.reflected_inertia_kg_m2 / (travel * travel)});
  }
  return joints;
}

Pose3 StartPose(const WorldSetup& setup) {
  const std::vector<Pose3> X_RL = StartPoses(setup.robot.tree);
  const Pose3 on_plane = FromGround(setup.X_GR_start, 0.0);
  double up_m = -1e9;
  for (const WheelFit& wheel : setup.robot.wheels) {
    const Eigen::Vector3d p_R = X_RL[static_cast<std::size_t>(wheel.link)] * wheel.p_LK;
    const Eigen::Vector3d p_G = on_plane * p_R;
    up_m = std::max(up_m,
                    setup.ground.heights.Height(p_G.x(), p_G.y()) + wheel.tyre.radius_m - p_R.z());
  }
  return FromGround(setup.X_GR_start, up_m);
}

Pose3 DockPose(const WorldSetup& setup) {
  const Pose2& at = setup.dock.X_DD_built;
  return FromGround(at, setup.ground.heights.Height(at.x, at.y));
}

// K of a wheel in its link: y along the axle.
Eigen::Matrix3d AxleAxes(const Eigen::Vector3d& axle_L) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), axle_L).toRotationMatrix();
}

// As of a tyre, by the motion of the wheel's centre.
double SlipOnSoil(const WheelFit& wheel, const LinkMotion& motion) {
  const Eigen::Vector3d axle_G = motion.X_GL.R * wheel.axle_L;
  const Eigen::Vector3d ahead_G = axle_G.cross(Eigen::Vector3d::UnitZ());
  if (ahead_G.isZero(1e-6)) return 0.0;
  TyreTruth truth;
  truth.rolling_m_s = RollingRadius(wheel.on_soil) * axle_G.dot(motion.w_GL_G);
  truth.along_m_s =
      motion.VelocityAt(motion.X_GL * wheel.p_LK).dot(ahead_G.normalized()) - truth.rolling_m_s;
  return truth.slip();
}

double TiltOf(const Eigen::Matrix3d& R_GB) { return std::acos(std::clamp(R_GB(2, 2), -1.0, 1.0)); }

}  // namespace

World::World(const WorldSetup& setup)
    : setup_(setup),
      X_WG_(SiteInWorld(setup.X_WG, setup.slope)),
      world_(GravityInSite(setup.slope)),
      robot_(AddTree(setup.robot.tree, JointsOf(setup.robot), StartPose(setup), TreeBase::kFree,
                     world_)),
      dock_(AddTree(setup.dock.tree, {}, DockPose(setup),
                    setup.dock.fixed ? TreeBase::kFixed : TreeBase::kFree, world_)),
      robot_drives_(setup.robot.tree.joints, robot_.places, world_.body(robot_.body)),
      dock_drives_(setup.dock.tree.joints, dock_.places, world_.body(dock_.body)),
      dock_solids_(SolidsOf(setup.dock.tree)),
      X_GD_start_(DockPose(setup)) {
  DOCKYARD_CHECK(setup.step_s > 0.0 && setup.step_s <= kLongestStep_s);
  world_.SetSolved(kSolvedHere);
  AddMotors();
  AddWheels();
  contacts_ = std::make_unique<WorldContacts>(setup_, world_, robot_, dock_);
  if (setup_.robot.imu) imu_.emplace(*setup_.robot.imu, GravityInSite(setup.slope));
  const std::vector<MotorCommand> braked(motors_.size());
  const long settle = std::lround(kSettle_s / setup_.step_s);
  for (long i = 0; i < settle; ++i) {
    Step(braked);
    if (i == 0) start_overlap_m_ = OverlapNow();
  }
  steps_ = 0;
  peak_touch_n_ = 0.0;
  const Pose3 X_DD_settled = Inverse(X_GD_start_) * dock_.Motion(world_, 0).X_GL;
  dock_settled_m_ = X_DD_settled.p.norm();
  dock_settled_rad_ = Eigen::AngleAxisd(X_DD_settled.R).angle();
  X_GD_start_ = dock_.Motion(world_, 0).X_GL;
  if (imu_) imu_->Start(robot_.Motion(world_, 0));
}

World::~World() = default;

void World::AddMotors() {
  const TreeBody& tree = world_.body(robot_.body);
  for (const MotorFit& fit : setup_.robot.motors) {
    const int link = robot_.Place(fit.link);
    const JointedLink& joint = setup_.robot.tree.joint(fit.link);
    const double inertia = ShaftInertia(joint, fit.travel_per_rad, tree, link);
    motors_.push_back({link, fit.travel_per_rad, MotorDrive(fit.model, inertia), {}});
    motors_.back().drive.ResetProfile(tree.angle_rad(link) / fit.travel_per_rad);
  }
}

void World::AddWheels() {
  if (setup_.soils.empty()) {
    std::vector<Tyre> tyres;
    for (const WheelFit& wheel : setup_.robot.wheels) {
      tyres.push_back({.link = robot_.Place(wheel.link),
                       .model = wheel.tyre,
                       .axle_L = wheel.axle_L,
                       .p_LK = wheel.p_LK});
    }
    tyres_.emplace(world_, setup_.ground, robot_.body, std::move(tyres));
    return;
  }
  for (const WheelFit& wheel : setup_.robot.wheels) {
    soils_.emplace_back(wheel.on_soil, setup_.soils.front());
    for (std::size_t i = 1; i < setup_.soils.size(); ++i) soils_.back().AddSoil(setup_.soils[i]);
  }
  soil_loads_.resize(soils_.size());
}

void World::Drive(const std::vector<MotorCommand>& commands) {
  DOCKYARD_CHECK(commands.size() == motors_.size());
  TreeBody& tree = world_.body(robot_.body);
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    Motor& motor = motors_[i];
    motor.output =
        motor.drive.Step(commands[i], tree.angle_rad(motor.link) / motor.travel_per_rad,
                         tree.rate_rad_s(motor.link) / motor.travel_per_rad, setup_.step_s);
    tree.AddJointTorque(motor.link, motor.output.torque_nm() / motor.travel_per_rad);
  }
  robot_drives_.Step(true, setup_.step_s, tree);
  dock_drives_.Step(true, setup_.step_s, world_.body(dock_.body));
}

void World::LoadWheels() {
  if (tyres_) return tyres_->AddContacts(setup_.step_s);
  TreeBody& tree = world_.body(robot_.body);
  for (std::size_t i = 0; i < soils_.size(); ++i) {
    const WheelFit& wheel = setup_.robot.wheels[i];
    const int link = robot_.Place(wheel.link);
    const LinkMotion& motion = tree.motion(link);
    const Pose3 X_GK = motion.X_GL * Pose3{AxleAxes(wheel.axle_L), wheel.p_LK};
    const Eigen::Vector3d v_G = motion.v_GL_G + motion.w_GL_G.cross(X_GK.p - motion.X_GL.p);
    soil_loads_[i] =
        soils_[i].Step(setup_.ground.heights, {X_GK, v_G, motion.w_GL_G}, setup_.step_s);
    tree.AddForce(link, soil_loads_[i].force_G, X_GK.p);
    tree.AddTorque(link, soil_loads_[i].torque_G);
  }
}

void World::Step(const std::vector<MotorCommand>& commands, const Eigen::Vector3d& push_G) {
  Drive(commands);
  LoadWheels();
  if (!push_G.isZero(0.0)) {
    const LinkMotion& root = robot_.Motion(world_, 0);
    world_.body(robot_.body).AddForce(0, push_G, root.X_GL * setup_.robot.tree.root.p_LoCom_L);
  }
  contacts_->AddAll(setup_.step_s);
  world_.Step(setup_.step_s);
  touch_n_ = contacts_->TakeForces(setup_.step_s);
  peak_touch_n_ = std::max(peak_touch_n_, touch_n_);
  RestDock();
  if (imu_) imu_->Add(robot_.Motion(world_, 0), setup_.step_s);
  ++steps_;
}

// One whose joints move never rests.
void World::RestDock() {
  if (world_.asleep(dock_.body) || !setup_.dock.tree.joints.empty()) return;
  const LinkMotion& root = dock_.Motion(world_, 0);
  const bool still = touch_n_ == 0.0 && root.v_GL_G.norm() + root.w_GL_G.norm() < kStill_m_s;
  dock_still_s_ = still ? dock_still_s_ + setup_.step_s : 0.0;
  if (dock_still_s_ >= kStill_s) world_.SetAsleep(dock_.body, true);
}

void World::PushDock(const Eigen::Vector3d& force_G) {
  world_.SetAsleep(dock_.body, false);
  const LinkMotion& root = dock_.Motion(world_, 0);
  world_.body(dock_.body).AddForce(0, force_G, root.X_GL * setup_.dock.tree.root.p_LoCom_L);
}

double World::OverlapNow() const {
  double most_m = 0.0;
  for (const PartContacts::Met& met : contacts_->parts.met()) {
    const WorldContact& contact = world_.contacts()[static_cast<std::size_t>(met.contact)];
    most_m = std::max(most_m, -contact.gap_m);
  }
  return most_m;
}

void World::FillWheels(Truth& truth) const {
  for (std::size_t i = 0; i < setup_.robot.wheels.size(); ++i) {
    if (tyres_) {
      const TyreTruth tyre = tyres_->truth(static_cast<int>(i), setup_.step_s);
      truth.wheel_load_n.push_back(tyre.load_n);
      truth.wheel_slip.push_back(tyre.slip());
    } else {
      truth.wheel_load_n.push_back(soil_loads_[i].force_G.z());
      truth.wheel_slip.push_back(
          SlipOnSoil(setup_.robot.wheels[i], robot_.Motion(world_, setup_.robot.wheels[i].link)));
    }
  }
}

void World::FillContacts(Truth& truth) const {
  const SpringPins& pins = contacts_->pins;
  for (const std::string& name : setup_.contacts) {
    ContactTruth& at = truth.contacts.emplace_back();
    at.closed = pins.IsClosed(name);
    at.force_n = pins.Force(name);
    at.offset_m = pins.Offset(name, world_);
    if (!at.closed) continue;
    for (const ElectricalParts* parts : {&setup_.dock.electrical, &setup_.robot.electrical}) {
      for (const ContactSupply& supply : parts->supplies) {
        if (supply.contact != name) continue;
        at.current_a = supply.draws_a;
        // There and back.
        at.voltage_v = std::max(
            0.0, supply.open_v - at.current_a * (supply.inner_ohm + 2.0 * supply.touch_ohm));
      }
    }
  }
}

void World::FillDock(Truth& truth) const {
  const Pose3& X_GD = dock_.Motion(world_, 0).X_GL;
  truth.dock_moved_m = (X_GD.p - X_GD_start_.p).norm();
  truth.dock_turned_rad = std::abs(WrapPi(ToGround(X_GD).heading - ToGround(X_GD_start_).heading));
  truth.dock_tilt_rad = TiltOf(X_GD.R);
  const NamedFrame& P = *setup_.robot.tree.Frame(setup_.robot_frame);
  const NamedFrame& Q = *setup_.dock.tree.Frame(setup_.dock_frame);
  truth.X_QP = Inverse(dock_.Motion(world_, Q.link).X_GL * Q.X_LF) *
               (robot_.Motion(world_, P.link).X_GL * P.X_LF);
}

Truth World::truth() const {
  Truth truth;
  truth.time_s = time_s();
  const TreeBody& tree = world_.body(robot_.body);
  for (int i = 0; i < setup_.robot.tree.link_count(); ++i) {
    truth.X_WL.push_back(X_WG_ * robot_.Motion(world_, i).X_GL);
  }
  for (int i = 0; i < setup_.dock.tree.link_count(); ++i) {
    truth.X_WK.push_back(X_WG_ * dock_.Motion(world_, i).X_GL);
  }
  const LinkMotion& root = robot_.Motion(world_, 0);
  truth.v_WR_W = X_WG_.R * root.v_GL_G;
  truth.w_WR_W = X_WG_.R * root.w_GL_G;
  truth.X_GR = root.X_GL;
  truth.X_DR = Inverse(dock_.Motion(world_, 0).X_GL) * root.X_GL;
  truth.speed_m_s = root.v_GL_G.norm();
  truth.turning_rad_s = root.w_GL_G.norm();
  truth.tilt_rad = TiltOf(root.X_GL.R);
  for (const Motor& motor : motors_) {
    truth.motors.push_back({tree.angle_rad(motor.link) / motor.travel_per_rad,
                            tree.rate_rad_s(motor.link) / motor.travel_per_rad,
                            motor.output.torque_nm(), motor.output.current_a,
                            motor.output.lead_rad});
  }
  for (const JointSwitch& each : setup_.robot.switches) {
    const JointedLink& joint = setup_.robot.tree.joint(each.link);
    const double moved = tree.angle_rad(robot_.Place(each.link)) - joint.start_rad;
    truth.switches.push_back(std::abs(moved) >= each.closes_rad);
  }
  for (const RangeFinder& each : setup_.robot.ranges) {
    const Pose3 X_GF = robot_.Motion(world_, each.link).X_GL * each.X_LF;
    truth.ranges_m.push_back(
        BeamLength(each, X_GF, dock_solids_, dock_, world_, setup_.ground.heights));
  }
  FillWheels(truth);
  FillContacts(truth);
  FillDock(truth);
  truth.touch_n = touch_n_;
  truth.peak_touch_n = peak_touch_n_;
  return truth;
}

LinkMotion World::MotionInWorld(int link) const {
  const LinkMotion& motion = robot_.Motion(world_, link);
  LinkMotion in_world;
  in_world.X_GL = X_WG_ * motion.X_GL;
  in_world.v_GL_G = X_WG_.R * motion.v_GL_G;
  in_world.w_GL_G = X_WG_.R * motion.w_GL_G;
  return in_world;
}

TrueImu World::TakeTrueImu() {
  return imu_ ? imu_->Take(robot_.Motion(world_, 0), X_WG_) : TrueImu(ImuSample{});
}

std::uint64_t World::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = world_.StateHash(HashBits(seed, static_cast<std::uint64_t>(steps_)));
  for (const Motor& motor : motors_) hash = motor.drive.StateHash(hash);
  for (const WheelSoil& soil : soils_) hash = soil.StateHash(hash);
  return dock_drives_.StateHash(robot_drives_.StateHash(hash));
}

}  // namespace dockyard::custom
