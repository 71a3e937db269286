// The keys of a robot's file as they are in it: with the names of links and joints.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "models/custom/robot_model.h"
#include "models/read/keys.h"
#include "models/read/load_camera_model.h"
#include "models/read/load_joints.h"
#include "models/read/load_pins.h"

namespace dockyard::custom {

/// The soil takes a wheel as a band. Assumed, 5-20 mm.
inline constexpr double kLeastWidth_m = 0.01;

struct WheelsFile {
  std::vector<std::string> links;
  TyreModel tyre;
  WheelModel on_soil;  // its paddles alone
};
struct MotorsFile {
  std::vector<std::string> joints;
  MotorModel model;
  double lead_m_per_turn = NAN;
};
struct SwitchFile {
  std::string name, joint;
  double closes_rad = NAN, closes_m = NAN;
  SensorTimes times;
};
struct RangeFile {
  std::string link;
  RangeFinder finder;
};

/// What is built off the drawing.
struct RobotErrors {
  double left_radius_scale = 1.0, right_radius_scale = 1.0;  // of wheels on that side
  double gear_friction_scale = 1.0, tyre_grip_scale = 1.0;
  Eigen::Vector3d pad_L{0, 0, 0};  // of all pins and pads
};

struct RobotFile {
  std::string urdf;
  JointsFile joints;
  std::vector<WheelsFile> wheels;
  std::vector<MotorsFile> motors;
  std::vector<CameraFile> cameras;
  std::vector<SwitchFile> switches;
  std::vector<RangeFile> ranges;
  PinsFile pins;
  RobotErrors errors;
  double mass_scale = 1.0;
};

void VisitRobot(Keys& keys, RobotModel& robot, RobotFile& file);

}  // namespace dockyard::custom
