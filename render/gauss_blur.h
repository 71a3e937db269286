// A Gaussian blur of an image. No GL.
#pragma once

#include "render/radiance_image.h"

namespace dockyard {

/// Gaussian blur; the border's values go on beyond it. 0: none.
void Blur(double sigma_px, RadianceImage& image);

}  // namespace dockyard
