#include "sim/vehicles/wheeled_body.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/rigid/solid_link.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// A hinge's friction is reached after so little turning. Assumed, 0.1-2 mrad.
constexpr double kFrictionBend_rad = 5e-4;

// A slender bar of this length along x about its middle; a thin one across.
Eigen::Matrix3d BarInertia(double mass_kg, double length_m) {
  constexpr double kThick_m = 0.03;  // assumed, 0.02-0.05
  const double across = mass_kg * kThick_m * kThick_m / 6.0;
  const double along = mass_kg * (length_m * length_m + kThick_m * kThick_m) / 12.0;
  return Vector3d(across, along, along).asDiagonal();
}

// A rim with the mass of half of it in the rim and half in the disc (assumed): about its axle 3/4 m
// r^2, about a diameter half of that and the width's part.
Eigen::Matrix3d WheelInertia(double mass_kg, const WheelModel& tyre) {
  const double r2 = tyre.rim_radius_m * tyre.rim_radius_m;
  const double about_axle = 0.75 * mass_kg * r2;
  const double across = 0.5 * about_axle + mass_kg * tyre.width_m * tyre.width_m / 12.0;
  return Vector3d(across, about_axle, across).asDiagonal();
}

// Half the track: where rockers and bogies are.
double SideOf(const RoverModel& rover, bool left) {
  double most = 0.0;
  for (const WheelPlan& wheel : rover.plan.wheels) most = std::max(most, std::abs(wheel.p_RW.y()));
  return left ? most : -most;
}

}  // namespace

void WheeledBody::AddHinge(std::vector<TreeLink>& links, const RoverModel& rover, bool left,
                           bool bogie) {
  const SuspensionModel& with = rover.suspension;
  const double y = SideOf(rover, left);
  const Vector3d pivot(with.pivot_x_m, y, with.pivot_z_m), joint(with.bogie_x_m, y, with.bogie_z_m);
  // From its hinge to the farthest wheel that it carries.
  double reach_m = 0.0;
  for (std::size_t i = 0; i < rover.plan.wheels.size(); ++i) {
    const Eigen::Vector2d& at = rover.plan.wheels[i].p_RW;
    if ((at.y() > 0.0) != left || rover.on_bogie[i] != bogie) continue;
    const double ahead_m = at.x() - (bogie ? joint.x() : pivot.x());
    if (std::abs(ahead_m) > std::abs(reach_m)) reach_m = ahead_m;
  }
  // A rocker's bar goes from its foremost wheel to the bogie; a bogie's from wheel to wheel.
  const Vector3d middle =
      bogie ? Vector3d(0.0, 0.0, 0.0) : Vector3d(0.5 * (reach_m + joint.x() - pivot.x()), 0.0, 0.0);
  const double length_m =
      bogie ? 2.0 * std::abs(reach_m) : std::abs(reach_m - (joint.x() - pivot.x()));
  const double mass_kg = bogie ? with.bogie_kg : with.rocker_kg;
  const int parent = bogie ? rocker_[left] : 0;
  links.push_back(SolidLink(parent, bogie ? Vector3d(joint - pivot) : pivot, Vector3d::UnitY(),
                            {mass_kg, middle, BarInertia(mass_kg, length_m)}));
  const int link = static_cast<int>(links.size()) - 1;
  (bogie ? bogie_ : rocker_)[left] = link;
  hinges_.push_back({link, bogie ? with.bogie_stop_rad : with.rocker_stop_rad});
}

void WheeledBody::AddWheel(std::vector<TreeLink>& links, const RoverModel& rover,
                           std::size_t wheel) {
  const WheelPlan& plan = rover.plan.wheels[wheel];
  const SuspensionModel& with = rover.suspension;
  const bool left = plan.p_RW.y() > 0.0, steered = plan.steer_limit_rad > 0.0;
  int parent = 0;
  Vector3d p_PL(plan.p_RW.x(), plan.p_RW.y(), 0.0);
  if (with.kind == SuspensionKind::kRockerBogie) {
    const double y = SideOf(rover, left);
    parent = rover.on_bogie[wheel] ? bogie_[left] : rocker_[left];
    p_PL -= rover.on_bogie[wheel] ? Vector3d(with.bogie_x_m, y, with.bogie_z_m)
                                  : Vector3d(with.pivot_x_m, y, with.pivot_z_m);
  }
  if (steered) {
    // A bracket from the arm above down to the axle: its centre half-way up the wheel.
    const double up_m = 0.5 * rover.tyre.rim_radius_m;
    links.push_back(
        SolidLink(parent, p_PL, Vector3d::UnitZ(),
                  {rover.bracket_kg, {0.0, 0.0, up_m}, BarInertia(rover.bracket_kg, 2.0 * up_m)},
                  rover.steer.reflected_inertia_kg_m2));
    parent = static_cast<int>(links.size()) - 1;
    bracket_link_.push_back(parent);
    p_PL.setZero();
  }
  links.push_back(
      SolidLink(parent, p_PL, Vector3d::UnitY(),
                {rover.wheel_kg, Vector3d::Zero(), WheelInertia(rover.wheel_kg, rover.tyre)},
                rover.drive.reflected_inertia_kg_m2));
  wheel_link_.push_back(static_cast<int>(links.size()) - 1);
}

std::vector<TreeLink> WheeledBody::LinksOf(const RoverModel& rover) {
  std::vector<TreeLink> links(1);
  links[0].model = rover.body;
  if (rover.suspension.kind == SuspensionKind::kRockerBogie) {
    for (const bool bogie : {false, true}) {
      for (const bool left : {true, false}) AddHinge(links, rover, left, bogie);
    }
  }
  for (std::size_t i = 0; i < rover.plan.wheels.size(); ++i) AddWheel(links, rover, i);
  if (rover.arm) {
    arm_link_ = static_cast<int>(links.size());
    for (TreeLink& link : ArmLinks(*rover.arm, arm_link_)) links.push_back(std::move(link));
  }
  if (rover.mast) {
    mast_link_ = static_cast<int>(links.size());
    for (TreeLink& link : MastLinks(*rover.mast, mast_link_)) links.push_back(std::move(link));
  }
  return links;
}

std::vector<JointTie> WheeledBody::TiesOf() const {
  if (rocker_[0] == 0) return {};
  return {{{rocker_[0], 1.0}, {rocker_[1], 1.0}}};
}

WheeledBody::WheeledBody(RigidWorld& world, const RoverModel& rover,
                         const std::vector<SoilModel>& soils, const Pose3& X_GB)
    : world_(world) {
  std::vector<TreeLink> links = LinksOf(rover);  // the ties name them
  number_ = world.Add(TreeBody(std::move(links), TiesOf(), X_GB));
  for (const Hinge& hinge : hinges_) {
    world.Limit({number_, hinge.link},
                StopsAt(rover.suspension.stop, -hinge.stop_rad, hinge.stop_rad));
  }
  hinge_friction_.limit_nm = rover.suspension.friction_nm;
  hinge_friction_.stiffness_nm_per_rad = rover.suspension.friction_nm / kFrictionBend_rad;
  const double drive_kg_m2 =
      rover.drive.reflected_inertia_kg_m2 + WheelInertia(rover.wheel_kg, rover.tyre)(1, 1);
  const double steer_kg_m2 =
      rover.steer.reflected_inertia_kg_m2 + WheelInertia(rover.wheel_kg, rover.tyre)(2, 2);
  for (const int link : wheel_link_) {
    motors_.push_back({link, MotorDrive(rover.drive, drive_kg_m2), {}});
    soils_.emplace_back(rover.tyre, soils.front());
    for (std::size_t i = 1; i < soils.size(); ++i) soils_.back().AddSoil(soils[i]);
  }
  for (const int link : bracket_link_) {
    motors_.push_back({link, MotorDrive(rover.steer, steer_kg_m2), {}});
  }
  loads_.resize(soils_.size());
  if (rover.arm) {
    arm_.emplace(*rover.arm, arm_link_, soils);
    arm_->Stow(tree());
    LimitArm(*rover.arm, {number_, arm_link_}, world);
    for (int i = 0; i < kArmMotors; ++i) {
      const MotorModel& motor = i == kArmRoll    ? rover.arm->roll
                                : i == kArmPitch ? rover.arm->pitch
                                                 : rover.arm->scoop_motor;
      motors_.push_back({arm_->link(i), MotorDrive(motor, ArmInertia(*rover.arm, i)), {}});
    }
  }
  if (!rover.mast) return;
  PutMast(rover.mast->stowed_rad);
  LimitMast(*rover.mast, {number_, mast_link_}, world);
  for (int i = 0; i < kMastMotors; ++i) {
    motors_.push_back(
        {mast_link(i), MotorDrive(rover.mast->motors[Place(i)], MastInertia(*rover.mast, i)), {}});
  }
}

void WheeledBody::PutMast(const std::array<double, 3>& angle_rad) {
  for (int i = 0; i < kMastMotors; ++i) tree().SetAngle(mast_link(i), angle_rad[Place(i)]);
}

bool WheeledBody::IsSuspension(int link) const {
  return std::any_of(hinges_.begin(), hinges_.end(),
                     [&](const Hinge& hinge) { return hinge.link == link; });
}

void WheeledBody::AddLoads(const std::vector<MotorCommand>& commands, double step_s,
                           HeightGrid& ground) {
  DOCKYARD_CHECK(commands.size() == motors_.size());
  TreeBody& tree = this->tree();
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    Motor& motor = motors_[i];
    motor.output = motor.drive.Step(commands[i], tree.angle_rad(motor.link),
                                    tree.rate_rad_s(motor.link), step_s);
    tree.AddJointTorque(motor.link, motor.output.torque_nm());
  }
  for (Hinge& hinge : hinges_) {
    tree.AddJointTorque(hinge.link, BristleTorque(hinge_friction_, tree.rate_rad_s(hinge.link),
                                                  step_s, hinge.bend_rad));
  }
  for (std::size_t i = 0; i < soils_.size(); ++i) {
    const LinkMotion& wheel = tree.motion(wheel_link_[i]);
    loads_[i] = soils_[i].Step(ground, {wheel.X_GL, wheel.v_GL_G, wheel.w_GL_G}, step_s);
    tree.AddForce(wheel_link_[i], loads_[i].force_G, wheel.X_GL.p);
    tree.AddTorque(wheel_link_[i], loads_[i].torque_G);
  }
  if (arm_) arm_->AddSoilLoads(tree, ground, step_s);
}

// The tree's own is the world's.
std::uint64_t WheeledBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Motor& motor : motors_) hash = motor.drive.StateHash(hash);
  for (const WheelSoil& soil : soils_) hash = soil.StateHash(hash);
  for (const Hinge& hinge : hinges_) hash = HashDouble(hash, hinge.bend_rad);
  return arm_ ? arm_->StateHash(hash) : hash;
}

}  // namespace dockyard
