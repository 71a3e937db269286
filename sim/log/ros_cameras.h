// Cameras of a run's log as ROS has them: lens, and what rectifies the images of a pair.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "controller/io/sensors.h"
#include "sim/log/stage.h"

namespace dockyard {

/// `r` and `p` of sensor_msgs/CameraInfo: the turn from the camera to its rectified image, and the
/// projection onto that image. A right camera has p(0, 3) = -f B with the baseline B.
struct RosRectification {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 3, 4> P = Eigen::Matrix<double, 3, 4>::Zero();
};

/// Of each camera. Two on one body whose names differ in `left` and `right` alone are a pair: their
/// rectified images have the left one's focal length and centre, and rows that match. The left
/// camera's axes stay as they are if the pair is parallel.
std::vector<RosRectification> RectificationsOf(const std::vector<NamedCamera>& cameras);

/// sensor_msgs/CameraInfo. A CAHV* lens has no distortion model of ROS: its focal lengths and
/// centre alone.
std::string CameraInfoMessage(Tick tick, const std::string& frame, const Camera& camera,
                              const RosRectification& rectification);

}  // namespace dockyard
