#include "sim/axel/drive_train.h"

#include <cmath>

#include "sim/base/hash.h"

namespace dockyard::axel {
namespace {

constexpr std::array<RoverLink, 3> kLinks = {RoverLink::kLeftWheel, RoverLink::kRightWheel,
                                             RoverLink::kArm};

// Inertia felt at a joint: link and body against each other, both free about y, and the rotor.
double JointInertia(const RoverModel& rover, const LinkModel& link, Motor motor) {
  const Eigen::Vector3d& c = link.p_LoCom_L;
  const double own = link.I_LCom_L(1, 1) + link.mass_kg * (c.x() * c.x() + c.z() * c.z());
  const double body = rover.body.I_LCom_L(1, 1);
  return own * body / (own + body) + rover.motors[static_cast<int>(motor)].reflected_inertia_kg_m2;
}

MotorDrive MakeDrive(const RoverModel& rover, Motor motor) {
  const MotorModel& model = rover.motors[static_cast<int>(motor)];
  switch (motor) {
    case Motor::kLeftWheel:
      return {model, JointInertia(rover, rover.left_wheel, motor)};
    case Motor::kRightWheel:
      return {model, JointInertia(rover, rover.right_wheel, motor)};
    case Motor::kArm:
      return {model, JointInertia(rover, rover.arm, motor)};
    case Motor::kSpool:
      break;
  }
  return {model, model.reflected_inertia_kg_m2};
}

}  // namespace

DriveTrain::DriveTrain(const RoverModel& rover, double arm_rad)
    : drum_radius_m_(rover.tether.drum_radius_m),
      drum_growth_m_per_rad_(rover.tether.drum_growth_m_per_turn / (2.0 * kPi)),
      drum_inertia_kg_m2_(rover.motors[static_cast<int>(Motor::kSpool)].reflected_inertia_kg_m2),
      drives_{MakeDrive(rover, Motor::kLeftWheel), MakeDrive(rover, Motor::kRightWheel),
              MakeDrive(rover, Motor::kArm), MakeDrive(rover, Motor::kSpool)} {
  zero_rad_[static_cast<int>(Motor::kArm)] = arm_rad;
}

void DriveTrain::Step(const std::array<MotorCommand, kMotorCount>& commands, double tension_n,
                      double dt_s, RoverBody& rover) {
  for (int i = 0; i < kMotorCount; ++i) {
    const Motor motor = static_cast<Motor>(i);
    output_[i] =
        drives_[i].Step(commands[i], angle_rad(motor, rover), speed_rad_s(motor, rover), dt_s);
  }
  for (RoverLink link : kLinks) {
    const int motor = static_cast<int>(link) - 1;
    rover.AddJointTorque(link, output_[motor].torque_nm());
  }
  // Cut through the tether at the arm's root: it pulls the arm's guide and the drum together.
  const double pull_nm = tension_n * drum_radius_m(rover);
  rover.AddJointTorque(RoverLink::kArm, pull_nm);
  // The body does not feel the tether's torque on the drum but the motor's reaction.
  const double drum_nm = output_[static_cast<int>(Motor::kSpool)].torque_nm();
  const Eigen::Vector3d y_G = rover.motion(RoverLink::kBody).X_GL.R.col(1);
  rover.AddTorque(RoverLink::kBody, (pull_nm - drum_nm) * y_G);

  drum_rad_s_ += (drum_nm - pull_nm) / drum_inertia_kg_m2_ * dt_s;
  drum_rad_ += drum_rad_s_ * dt_s;
}

void DriveTrain::PowerOn(const RoverBody& rover) {
  for (RoverLink link : kLinks) zero_rad_[static_cast<int>(link) - 1] = rover.joint_rad(link);
  drum_rad_ = 0.0;
  for (MotorDrive& drive : drives_) drive.ResetProfile(0.0);
}

double DriveTrain::angle_rad(Motor motor, const RoverBody& rover) const {
  if (motor == Motor::kSpool) return drum_rad_;
  const int i = static_cast<int>(motor);
  return rover.joint_rad(kLinks[i]) - zero_rad_[i];
}

double DriveTrain::speed_rad_s(Motor motor, const RoverBody& rover) const {
  return motor == Motor::kSpool ? drum_rad_s_ : rover.joint_rad_s(kLinks[static_cast<int>(motor)]);
}

double DriveTrain::tether_given_m(const RoverBody& rover) const {
  const double wound = wound_rad(rover);
  return -(drum_radius_m_ + 0.5 * drum_growth_m_per_rad_ * wound) * wound;
}

double DriveTrain::tether_rate_m_s(const RoverBody& rover) const {
  return drum_radius_m(rover) * (speed_rad_s(Motor::kArm, rover) - drum_rad_s_);
}

bool DriveTrain::IsStill(double rad_s, double dt_s) const {
  bool still = std::abs(drum_rad_s_) < rad_s;
  for (const MotorDrive& drive : drives_) {
    still = still && std::abs(drive.profile_moved_rad()) < rad_s * dt_s;
  }
  return still;
}

std::uint64_t DriveTrain::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashDouble(HashDouble(seed, drum_rad_), drum_rad_s_);
  for (const MotorDrive& drive : drives_) hash = drive.StateHash(hash);
  return hash;
}

}  // namespace dockyard::axel
