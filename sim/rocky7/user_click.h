// What a user clicks on in the first picture.
#pragma once

#include <Eigen/Core>

#include "sim/rocky7/build_run.h"

namespace dockyard::rocky7 {

struct UserClick {
  Eigen::Vector2d pixel{0, 0};  // of the left camera
  Eigen::Vector3d target_G{0, 0, 0};
};

/// The pixel that shows the target's middle, with the error of the hand. A stone stays the target
/// where the click falls on ground; a click that shows another stone is made again, and where
/// another stone hides the middle, the click means the middle of what is visible. On a boulder the
/// target is the point that the click shows. Who sees that it lies on another surface than the face
/// that is meant clicks again.
/// @param truth  of the start
/// Throws ConfigError when the target is not in that image, or hidden in it.
UserClick ClickOn(const Scenario& scenario, const BuiltRun& run, const Truth& truth);

}  // namespace dockyard::rocky7
