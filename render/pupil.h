// A lens whose entrance pupil moves with the angle has no single centre, but a flat view is drawn
// from one point. The end of a ray in the scene decides which point of the flat view the ray shows.
#pragma once

#include <vector>

#include "controller/geometry/camera.h"
#include "render/scene.h"

namespace dockyard {

/// The surfaces on which rays are taken to end: the nearest board's plate, exactly; else the level
/// ground under the yard; else nothing, far away. Other things are drawn where the surface behind
/// them would be: wrong by at most the pupil's shift over their distance.
class RayEnds {
 public:
  RayEnds(const Scene& scene, const Pose3& X_WC);
  /// The point in the tan plane of the camera's origin that the ray shows. tan: the ray's own
  /// direction over its z; o: its origin [m].
  Eigen::Vector2d Seen(const Eigen::Vector3d& o, const Eigen::Vector2d& tan) const;

 private:
  struct Plate {
    Pose3 X_BC;
    double half_width, half_height;  // with a margin
  };
  std::vector<Plate> plates_;
  Eigen::Vector3d up_C_;
  double height_ = 0.0;  // of the camera above the ground
};

}  // namespace dockyard
