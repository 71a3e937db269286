// models/<rover>/<rover>.yaml and the URDF that it names -> RoverModel.
#pragma once

#include <string>

#include "models/axel/axel_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/read/mesh_loader.h"

namespace dockyard::axel {

inline constexpr int kDefaultImageWidth = 1024, kDefaultImageHeight = 768;

/// Names every key of the file.
void VisitRoverKeys(Keys& keys);

/// The URDF must have the links body (its root), left_wheel, right_wheel and arm, and the joints
/// left_wheel_joint, right_wheel_joint (continuous) and arm_joint (revolute, at the body's origin),
/// all about +y. The scenario sets the images' size; 0: as in the cameras' file, else the default.
/// `changes` are keys on top of the file's; the URDF's wheels, arm and camera heads follow them.
/// Throws ConfigError, also for cameras that have the rover's own body before them.
RoverModel LoadRover(const std::string& file, int image_width = 0, int image_height = 0,
                     const ModelChanges& changes = {}, MeshStore* meshes = nullptr);

}  // namespace dockyard::axel
