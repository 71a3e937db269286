#include "controller/custom/drive.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/motion/limits.h"

namespace dockyard::custom {
namespace {

// Share of the turns of wheels without side slip. Skid-steered robots turn about 0.5-0.8 of it: the
// instantaneous centres of the sides' treads lie outside of the wheels (Mandow et al., IROS 2007).
// Assumed, 0.5-0.9; the inertial unit corrects it (odometry.h).
constexpr double kSkidShare = 0.67;
// An axle points along y within this, and wheels are in one line within this share of the gauge.
// Assumed, 2-10 deg and 0.02-0.1.
constexpr double kAxle_rad = Radians(5.0), kInLine = 0.05;
constexpr double kSameRim =
    0.01;  // rims on one motor run alike within this share; assumed, 0.5-2 %

double ForwardSign(const RobotWheel& wheel) {
  return wheel.axle_R.cross(Eigen::Vector3d::UnitZ()).x() > 0.0 ? 1.0 : -1.0;
}

std::optional<std::string> FaultOf(const Nominal& nominal, const RobotWheel& wheel) {
  const std::string name = "wheel " + wheel.link + ": ";
  if (wheel.steering >= 0)
    return name + "it is steered; expected a robot that turns by its sides' speeds";
  if (wheel.drive < 0) return std::nullopt;
  if (wheel.ball || wheel.swivels)
    return name + "it is driven; expected a wheel that keeps its direction";
  if (wheel.drive >= static_cast<int>(nominal.motors.size()))
    return name + "its motor is not in the list of motors";
  if (std::abs(wheel.axle_R.normalized().y()) < std::cos(kAxle_rad))
    return name + "its axle points elsewhere; expected along y of the robot, within 5 deg";
  if (!(wheel.radius_m > 0.0)) return name + "expected a radius above zero";
  const JointDrive& motor = nominal.motors[static_cast<std::size_t>(wheel.drive)];
  if (motor.travel_per_rad == 0.0) return name + "its motor does not move its joint";
  if (!(motor.motor.max_speed_rad_s > 0.0) || !(motor.motor.max_accel_rad_s2 > 0.0))
    return name + "expected a motor with speed and acceleration above zero";
  return std::nullopt;
}

/// Sides, places and travels of the wheels, which have no faults of their own.
Drive Measured(const Nominal& nominal, const std::vector<const RobotWheel*>& driven) {
  double middle_y = 0.0, middle_x = 0.0, y[2] = {0.0, 0.0};
  const double count = static_cast<double>(driven.size());
  for (const RobotWheel* wheel : driven) {
    middle_x += wheel->p_RK.x() / count;
    middle_y += wheel->p_RK.y() / count;
  }
  Drive drive;
  for (const RobotWheel* wheel : driven) {
    const double travel = nominal.motors[static_cast<std::size_t>(wheel->drive)].travel_per_rad;
    const double side = wheel->p_RK.y() > middle_y ? 1.0 : -1.0;
    drive.wheels.push_back({.motor = wheel->drive,
                            .side = side,
                            .travel_m_per_rad = ForwardSign(*wheel) * wheel->radius_m * travel});
    y[side > 0.0 ? 0 : 1] += 2.0 * wheel->p_RK.y() / count;
  }
  drive.gauge_m = y[0] - y[1];
  drive.X_RA = {middle_x, middle_y, 0.0};
  drive.turn_share = driven.size() == 2 ? 1.0 : kSkidShare;
  return drive;
}

std::optional<std::string> FaultOf(const Drive& drive,
                                   const std::vector<const RobotWheel*>& driven) {
  double balance = 0.0, torsion_m = 0.0;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const DrivenWheel& wheel = drive.wheels[i];
    balance += wheel.side;
    torsion_m += wheel.side * driven[i]->p_RK.x() * 2.0 / static_cast<double>(driven.size());
    for (const DrivenWheel& other : drive.wheels) {
      if (other.motor == wheel.motor &&
          (other.side != wheel.side || std::abs(other.travel_m_per_rad - wheel.travel_m_per_rad) >
                                           kSameRim * std::abs(wheel.travel_m_per_rad)))
        return "wheel " + driven[i]->link + ": its motor drives an unlike wheel, too";
    }
  }
  if (balance != 0.0 || !(drive.gauge_m > 0.0))
    return std::string("driven wheels: expected the same number on each side");
  if (std::abs(torsion_m) > kInLine * drive.gauge_m)
    return std::string("driven wheels: expected both sides at the same x of the robot");
  return std::nullopt;
}

}  // namespace

Result<Drive, Refusal> FindDrive(const Nominal& nominal) {
  std::vector<const RobotWheel*> driven;
  for (const RobotWheel& wheel : nominal.wheels) {
    if (const auto fault = FaultOf(nominal, wheel)) return Refusal{*fault};
    if (wheel.drive >= 0) driven.push_back(&wheel);
  }
  if (driven.size() != 2 && driven.size() != 4 && driven.size() != 6)
    return Refusal{"driven wheels: there are " + std::to_string(driven.size()) +
                   ", expected 2, 4 or 6"};
  const Drive drive = Measured(nominal, driven);
  if (const auto fault = FaultOf(drive, driven)) return Refusal{*fault};
  for (const RobotWheel& wheel : nominal.wheels) {
    const bool rolls_aside = wheel.ball || wheel.swivels || wheel.drive >= 0;
    if (!rolls_aside && std::abs(wheel.p_RK.x() - drive.X_RA.x) > kInLine * drive.gauge_m)
      return Refusal{"wheel " + wheel.link +
                     ": fixed and not driven off the driven axle; expected a caster or a ball"};
  }
  return drive;
}

double MotorSpeed(const Drive& drive, const DrivenWheel& wheel, const Twist& twist) {
  const double across_m_s = 0.5 * drive.gauge_m / drive.turn_share * twist.turn_rad_s;
  return (twist.speed_m_s - wheel.side * across_m_s) / wheel.travel_m_per_rad;
}

double ShareWithinMotors(const Drive& drive, const Nominal& nominal, const Twist& twist) {
  double share = 1.0;
  for (const DrivenWheel& wheel : drive.wheels) {
    const double most = nominal.motors[static_cast<std::size_t>(wheel.motor)].motor.max_speed_rad_s;
    const double speed = std::abs(MotorSpeed(drive, wheel, twist));
    if (speed > most) share = std::min(share, most / speed);
  }
  return share;
}

Commands RunAt(const Drive& drive, const Nominal& nominal, const Twist& twist) {
  const double share = ShareWithinMotors(drive, nominal, twist);
  const Twist run{share * twist.speed_m_s, share * twist.turn_rad_s};
  Commands commands;
  commands.motors.resize(nominal.motors.size());
  for (const DrivenWheel& wheel : drive.wheels) {
    const auto i = static_cast<std::size_t>(wheel.motor);
    const NominalMotor& limits = nominal.motors[i].motor;
    commands.motors[i] = {.mode = MotorMode::kVelocity,
                          .target = MotorSpeed(drive, wheel, run),
                          .accel_rad_s2 = limits.max_accel_rad_s2,
                          .current_limit_a = limits.max_current_a};
  }
  std::vector<NominalMotor> limits;
  for (const JointDrive& motor : nominal.motors) limits.push_back(motor.motor);
  KeepLimits(limits, &commands);
  return commands;
}

}  // namespace dockyard::custom
