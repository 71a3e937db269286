// models/<rover>/<rover>.yaml and the URDF that it names -> RoverModel.
#pragma once

#include <string>

#include "models/rover_model.h"
#include "models/yaml_tree.h"

namespace dockyard {

inline constexpr int kDefaultImageWidth = 1024, kDefaultImageHeight = 768;

/// The URDF must have the links body (its root), left_wheel, right_wheel and arm, and the joints
/// left_wheel_joint, right_wheel_joint (continuous) and arm_joint (revolute, at the body's origin),
/// all about +y. The images' size belongs to the scenario; `changes` are keys on top of the file's.
/// Throws ConfigError.
RoverModel LoadRover(const std::string& file, int image_width = kDefaultImageWidth,
                     int image_height = kDefaultImageHeight, const YamlNode* changes = nullptr);

}  // namespace dockyard
