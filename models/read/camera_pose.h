// Where a file places a camera, in each of the forms in which it may say so.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// `position_m`, and one of: yaw_deg, pitch_deg, roll_deg; rotation; rotation_wxyz.
const std::vector<std::string>& PoseKeys();

/// A body's pose: x forward, y left, z up without a turn.
Pose3 ReadBodyPose(const YamlReader& in);
/// A camera's pose. Angles turn a camera with its view along the frame's x and z up; `rotation`
/// and `rotation_wxyz` are R_FC itself, whose columns are the camera's axes right, down, ahead.
Pose3 ReadCameraPose(const YamlReader& in);

/// The rotation next to a matrix that a file gives with few digits. Throws ConfigError, its message
/// opening with `place`, for a matrix that is none within 0.005, or left-handed.
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& read, const std::string& place);

}  // namespace dockyard
