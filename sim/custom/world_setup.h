// What a world is made of.
#pragma once

#include <string>
#include <vector>

#include "models/custom/dock_model.h"
#include "models/custom/robot_model.h"
#include "models/parts/soil_model.h"
#include "sim/rigid/slope.h"
#include "sim/vehicles/firm_ground.h"

namespace dockyard::custom {

/// Longer steps do not hold contacts of this stiffness. Assumed, 1-2 ms.
inline constexpr double kLongestStep_s = 2e-3;

struct WorldSetup {
  RobotModel robot;
  DockModel dock;
  FirmGround ground;             // in the site frame G, which is D
  std::vector<SoilModel> soils;  // by the ground's numbers, in place of its floors; empty: firm
  Pose2 X_WG;                    // site in the world, before it is tilted
  Slope slope;
  Pose2 X_GR_start;                     // the robot in plan
  std::string robot_frame, dock_frame;  // which meet when docked
  std::vector<std::string> contacts;    // names of the electrical contacts
  double step_s = 1e-3;
};

}  // namespace dockyard::custom
