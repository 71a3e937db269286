// The exposure that a camera has found in the image before.
#pragma once

namespace dockyard {

/// Kept by a camera, or by a pair that is exposed together, from image to image.
struct KeptExposure {
  double electrons = 0.0;  // of a pixel whose radiance is 1, without stops; 0: no image yet
};

}  // namespace dockyard
