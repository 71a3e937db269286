// A room with a dock as indoor robots have it: a flat plain floor, walls, boxes, a small board, a
// robot of some meshes with one camera low over the floor.
#pragma once

#include <memory>
#include <vector>

#include "render/scene.h"

namespace dockyard {

struct DockRoom {
  /// light: of the sun's kind, as that of a window; sky alone without it.
  explicit DockRoom(double sun_irradiance = 0.6);

  /// The camera's place, its view towards the board: range_m before it, off_m to the side, 0.25 m
  /// over the floor.
  Pose3 CameraAt(double range_m, double off_m = 0.0, double yaw_rad = 0.0) const;
  /// The scene with the robot where its camera is. It borrows this room's heights.
  Scene SceneAt(const Pose3& X_WC) const;

  std::vector<double> heights_m;
  Scene still;                       // all but the robot
  std::vector<SceneObject> robot_C;  // posed in the camera's frame
};

}  // namespace dockyard
