// The rays of the cameras drawn last, kept from image to image. No GL.
#pragma once

#include <memory>
#include <vector>

#include "render/fisheye_warp.h"
#include "render/pixel_row.h"
#include "render/scene.h"

namespace dockyard {

/// A camera's pixels in the tan plane.
struct KeptLens {
  TanScale scale;
  TanRect rect;
  PixelGrid grid{};
};

/// A lens's table costs up to 0.1 s, its grid milliseconds: both are made once for each camera.
class KeptLenses {
 public:
  /// The grid is made anew only where the pupil moves, as its pixels depend on where their rays end
  /// in the scene. Good until the next call.
  const KeptLens& Of(const Camera& camera, const LensRipple& ripple, const Scene& scene,
                     const Pose3& X_WC);

 private:
  // Enough for three pairs and six single cameras; 13 MB each at 1024 x 768.
  static constexpr std::size_t kMost = 12;
  std::vector<std::unique_ptr<KeptLens>> lenses_;  // the one used last comes first
};

}  // namespace dockyard
