// A small image of a known scene, for comparing computers and for seeing that drawing works at all.
#pragma once

#include <cstdint>

#include "controller/geometry/image.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Ground, a box, a tether, the sun, and a white board with one black disc, 1.4 m before the
/// cameras: 96 x 72 pixels.
StereoImages TestImages(StereoRenderer& renderer);

/// Of all pixels of both: equal on computers whose images are equal.
std::uint64_t ImageFingerprint(const StereoImages& images);

/// Whether the left image shows a sunlit plate round a disc that is a good deal darker, and a sky.
bool ShowsTheTestScene(const GrayImage& left);

}  // namespace dockyard
