// Rocky 7: the rover with its cameras and its inertial unit.
#pragma once

#include "models/parts/cameras.h"
#include "models/parts/imu.h"
#include "models/parts/rover_model.h"

namespace dockyard::rocky7 {

struct RobotModel {
  RoverModel rover;
  StereoModel front;  // its places are those in R, at the height of the axles
  ImuModel imu;
};

}  // namespace dockyard::rocky7
