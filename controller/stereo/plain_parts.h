// Parts of a picture with nothing to match, as the sky.
#pragma once

#include "controller/geometry/image.h"
#include "controller/stereo/match.h"

namespace dockyard {

struct PlainSettings {
  int about_px = 11;            // side of what is looked at; assumed, 7-15
  double least_contrast = 1.0;  // grey, one sigma without noise; assumed, 0.5-1.5
};

/// Leaves disparities out where the left picture, rectified as they are, shows no contrast: the
/// semi-global matcher carries those from beside it there.
Disparities WithoutPlainParts(Disparities disparities, const GrayImage& left,
                              const PlainSettings& settings = {});

}  // namespace dockyard
