// Rocky 7: the rover with its cameras and its inertial unit.
#pragma once

#include "models/parts/cameras.h"
#include "models/parts/imu.h"
#include "models/parts/rover_model.h"

namespace dockyard::rocky7 {

struct RobotModel {
  RoverModel rover;
  // Places of the body pairs are those in R, at the height of the axles; of the mast's pair in K,
  // its second link.
  StereoModel front, back, mast_pair;
  ImuModel imu;
};

}  // namespace dockyard::rocky7
