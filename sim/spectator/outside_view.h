// The world of a logged run from outside, as a image for people.
#pragma once

#include <cstddef>
#include <optional>

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "render/stereo_renderer.h"
#include "sim/spectator/aim_point.h"
#include "sim/spectator/outside_scene.h"

namespace dockyard {

struct OutsideOptions {
  int width = 960, height = 540;  // [px]
  std::optional<Eigen::Vector3d>
      from_D{};             // of the camera; none: where it sees all, or near the point
  std::optional<Aim> at{};  // none: robot and target
};

/// One camera that does not move, with one exposure for all images. With `at` it turns so that the
/// point stays in the middle. Run, shapes and renderer must outlive it.
class OutsideView {
 public:
  /// The camera sees the target and the robot from sample `first` to `last` (SpectatorPose), or the
  /// point (FindNearView). Throws as OutsideScenes.
  OutsideView(const LoggedRun& run, const StageShapes& shapes, const OutsideOptions& options,
              std::size_t first, std::size_t last, StereoRenderer& renderer);

  /// Samples must not fall. 8 bits in sRGB.
  RgbImage Image(std::size_t sample);

 private:
  const LoggedRun& run_;
  const StageShapes& shapes_;
  std::optional<Aim> at_;
  OutsideScenes scenes_;
  Camera camera_;
  Pose3 X_WC_;
  StereoRenderer& renderer_;
  double gain_ = 0.0;  // to linear 0..1, from the first image on
};

}  // namespace dockyard
