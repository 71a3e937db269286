// A mark's edges in an image, below the pixel: where its colour is halfway between the mark's and
// that of the surroundings.
#pragma once

#include <optional>

#include "controller/geometry/image.h"
#include "controller/vision/colour_blobs.h"

namespace dockyard::raposa {

/// @param rough  the mark's bounding region, to within two pixels
/// @return  the region by half levels of linear light, each side by its outermost tenth; none where
///          the image's border is too near or mark and surroundings are alike
std::optional<BlobBounds> HalfLevelBounds(const RgbImage& image, const BlobBounds& rough);

}  // namespace dockyard::raposa
