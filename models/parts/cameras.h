// A stereo pair with its sensors and its manufacturing errors.
#pragma once

#include "controller/geometry/camera.h"
#include "models/parts/camera_sensor.h"

namespace dockyard {

/// The stereo pair as designed, and how far the built one may be off (1 sigma each).
struct StereoModel {
  StereoRig nominal;     // with both mountings
  Pose3 mounting;        // of the pair as a whole, about its middle, in R's axes
  Pose3 right_mounting;  // of the right camera, about its centre, before that of the pair
  double relative_yaw_sigma_rad = 0.0;  // right against left camera
  double rotation_sigma_rad = 0.0;      // each camera, roll and pitch
  LensErrors lens;                      // of each camera
  SensorModel sensor;
};

}  // namespace dockyard
