// The true places of the fiducials in an image, from geometry alone.
#pragma once

#include <optional>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "render/lens_ripple.h"
#include "render/scene.h"

namespace dockyard::axel {

struct FiducialPixels {
  std::optional<Eigen::Vector2d> centre;    // projection of the disc's centre [px]
  std::optional<Eigen::Vector2d> centroid;  // centroid of the projected disc's area [px]
  bool whole = false;                       // the disc lies on the image entirely
  double hidden = 0.0;                      // share of the disc behind other objects, 0..1
};

/// One entry per fiducial of the scene's board, seen by the camera at X_WC, whose lens has this
/// ripple.
std::vector<FiducialPixels> TrueFiducials(const Scene& scene, const Camera& camera,
                                          const Pose3& X_WC, const LensRipple& ripple = {});

}  // namespace dockyard::axel
