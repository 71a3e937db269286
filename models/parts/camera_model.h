// One camera on a link of a robot, with its sensor and its manufacturing errors.
#pragma once

#include <string>

#include "controller/geometry/camera.h"
#include "models/parts/camera_sensor.h"

namespace dockyard {

/// How far the built camera may be off its design, 1 sigma each.
struct CameraErrors {
  double rotation_sigma_rad = 0.0;  // roll, pitch and yaw
  double place_sigma_m = 0.0;       // along each axis
  LensErrors lens;
};

/// The camera as designed.
struct CameraModel {
  std::string name, link;
  bool colour = false;
  Camera nominal;
  Pose3 X_LC;  // in its link
  CameraErrors errors;
  // A colour camera has no bits, response_sigma, focus, bracket, exposure by the image before,
  // video, readout or defects.
  SensorModel sensor;
  double period_s = 0.1;   // from image to image
  double latency_s = 0.0;  // from the middle of an exposure until the controller has the image
};

}  // namespace dockyard
