// What a scenario asks of a docking: conditions that hold together for a time, and a trial.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "models/read/keys.h"

namespace dockyard::custom {

inline constexpr double kNotAsked = std::numeric_limits<double>::quiet_NaN();

/// A frame of the robot in a frame of the dock: how far each number may be off 0. NaN: it may be
/// anything.
struct PoseBox {
  std::string robot, dock;  // links of the URDF files
  double x_m = kNotAsked, y_m = kNotAsked, z_m = kNotAsked;
  double roll_rad = kNotAsked, pitch_rad = kNotAsked, yaw_rad = kNotAsked;
};

struct ContactAsked {
  std::string pins;  // name of an electrical contact; empty: none is asked
  bool closed = true;
  double least_n = kNotAsked;  // sum of its pins' forces
};

struct Condition {
  PoseBox pose;
  ContactAsked contact;
  double most_n = kNotAsked;    // between robot and dock
  double most_m_s = kNotAsked;  // of the robot
};

/// What is done to a docked robot. It must keep what is asked of it.
struct TrialKeys {
  double push_n = 0.0;                   // on its root, level
  std::vector<double> towards_rad{0.0};  // one push each, from x of D
  double for_s = 1.0;                    // each push
  double shake_n = 0.0, shake_hz = 2.0;  // a push to and fro along y of D
  double drive_m_s = 0.0;                // its wheels drive at this speed, away from the dock
  ContactAsked contact;
  PoseBox pose;
};

struct JudgeKeys {
  double hold_s = 1.0;
  Condition docked;
  TrialKeys trial;
  double pushed_m = 0.02, pushed_rad = 0.0349;  // a dock that is moved by more was pushed: 2 deg
  double collided_n = 300.0;                    // a blow that bends plastic; assumed, 100-1000
  double tipped_rad = 0.7854;                   // 45 deg
};

void VisitJudge(Keys& keys, JudgeKeys& judge);

}  // namespace dockyard::custom
