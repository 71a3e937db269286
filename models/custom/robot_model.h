// A robot that is described by files: links and joints by its URDF, and what a URDF has no word for
// by a YAML file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/parts/camera_model.h"
#include "models/parts/imu.h"
#include "models/parts/link_tree.h"
#include "models/parts/motor.h"
#include "models/parts/spring_pins.h"
#include "models/parts/tyre.h"
#include "models/parts/wheel.h"

namespace dockyard::custom {

/// A link that rolls on the ground.
struct WheelFit {
  int link = 0;
  TyreModel tyre;
  Eigen::Vector3d axle_L{0, 1, 0};  // unit, of its joint; to the left as far as that has a side
  Eigen::Vector3d p_LK{0, 0, 0};    // its centre
  WheelModel on_soil;               // where the ground yields
};

/// A motor on a joint, commanded by the controller.
struct MotorFit {
  std::string joint;
  int link = 0;  // that the joint carries
  MotorModel model;
  double travel_per_rad = 1.0;  // of the joint for a turn of the motor's output; of a slide [m]
};

struct CameraFit {
  CameraModel model;  // its pose is in the frame of `link`
  int link = 0;
};

/// Times of a sensor of one number.
struct SensorTimes {
  double rate_hz = 50.0, latency_s = 0.0;
};

/// Closes while its joint has moved from its start by this much or more, to either side.
struct JointSwitch {
  std::string name;
  int link = 0;
  double closes_rad = 0.0;  // of a slide [m]
  SensorTimes times;
};

/// One beam along the x axis of a frame, to the dock's solids and the ground.
struct RangeFinder {
  std::string name;
  int link = 0;
  Pose3 X_LF;
  double least_m = 0.0, most_m = 0.0;  // beyond them it reads most_m
  double noise_m = 0.0, step_m = 0.0;
  SensorTimes times;
};

/// How voltage and current of the charging contact are read.
struct ChargeSensors {
  double voltage_noise_v = 0.0, current_noise_a = 0.0;
  SensorTimes times;
};

struct RobotModel {
  std::string name;
  LinkTree tree;
  std::vector<WheelFit> wheels;
  std::vector<MotorFit> motors;
  std::vector<CameraFit> cameras;
  std::optional<ImuModel> imu;
  std::vector<JointSwitch> switches;
  std::vector<RangeFinder> ranges;
  ElectricalParts electrical;
  ChargeSensors charge;
  double floor_grip = 0.5;  // of its solids on the floor, a share of rubber's; assumed, 0.3-1
};

}  // namespace dockyard::custom
