// How a camera was held, as it wrote beside its image.
#pragma once

#include <string_view>

#include "controller/geometry/image.h"

namespace dockyard {

/// The orientation that a PNG's or JPEG's EXIF states (CIPA DC-008, tag 274), 1 to 8; 1, upright,
/// when it states none.
int OrientationOf(std::string_view file);

/// The image turned upright.
GrayImage Upright(GrayImage image, int orientation);
RgbImage Upright(RgbImage image, int orientation);

}  // namespace dockyard
