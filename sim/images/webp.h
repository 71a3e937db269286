// Images as WebP files' bytes, small enough for a report.
#pragma once

#include <string>

#include "controller/geometry/image.h"

namespace dockyard {

/// Lossy. Empty for an image that WebP cannot hold: over 16 383 pixels on a side.
/// @param quality  0 to 100; 50 takes 3 kB and 3 ms for 512 x 384 pixels
std::string EncodeWebp(const RgbImage& image, double quality);

}  // namespace dockyard
