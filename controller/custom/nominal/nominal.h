// The nominal parameters of a robot and a dock that are described by files: what drawings and
// calibration tell a controller. The world is built from its own numbers, which differ.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "controller/custom/nominal/docking.h"
#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/io/nominal_motor.h"

namespace dockyard::custom {

/// A motor on a joint, in the order of Commands::motors.
struct JointDrive {
  std::string joint;
  NominalMotor motor;
  double travel_per_rad = 1.0;  // of the joint for a turn of the output; of a slide [m]

  bool operator==(const JointDrive&) const = default;
};

/// A wheel on the floor. Its place is that at the joints' start angles.
struct RobotWheel {
  std::string link;
  Eigen::Vector3d p_RK{0, 0, 0};    // its centre
  Eigen::Vector3d axle_R{0, 1, 0};  // unit; a positive turn about it
  double radius_m = 0.0, width_m = 0.0;
  bool ball = false;     // rolls to all sides
  int drive = -1;        // the motor that turns it; -1: none
  int steering = -1;     // the motor that steers it; -1: none
  bool swivels = false;  // by a free joint: a caster
  // Of a steered wheel or a caster, where its vertical joint is.
  Eigen::Vector3d p_RS{0, 0, 0};

  bool operator==(const RobotWheel&) const = default;
};

/// A camera on a link, at the joints' start angles.
struct RobotCamera {
  std::string name;
  Camera camera;
  Pose3 X_RC;
  bool colour = false;
  double period_s = 0.0;   // the shortest between two images
  double latency_s = 0.0;  // from the exposure to the frame that brings the image
};

/// A board of marks on the dock. B as FiducialBoard has it.
struct DockBoard {
  std::string name;
  FiducialBoard board;
  Pose3 X_DB;
};

/// R: the robot's root link. x forward, y left, z up. D: the dock's root link, on the ground; x out
/// of the dock to where robots come from, z up.
struct Nominal {
  std::string name;
  double control_period_s = 0.02;
  std::vector<JointDrive> motors;
  std::vector<RobotWheel> wheels;
  double height_m = 0.0;  // of R's origin over level ground
  std::vector<RobotCamera> cameras;
  std::vector<DockBoard> boards;
  std::vector<std::string> sensors;  // names, in the order of SensorFrame::values
  // The robot is docked where its frame P lies on the dock's frame Q: X_DR = X_DQ * Inverse(X_RP).
  Pose3 X_RP, X_DQ;
  std::string contact;             // the electrical contact that closes when docked; empty: none
  double contact_voltage_v = 0.0;  // of the contact's source, with a sensor <contact>_voltage_v
  bool has_imu = false;            // without an inertial unit SensorFrame::imu stays zero
  DockingOptions docking;

  Pose3 X_DR_docked() const { return X_DQ * Inverse(X_RP); }
};

/// The place of a sensor's value by its name; -1: there is none.
inline int SensorOf(const Nominal& nominal, const std::string& name) {
  for (std::size_t i = 0; i < nominal.sensors.size(); ++i) {
    if (nominal.sensors[i] == name) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace dockyard::custom
