// What lies on the window close before a lens: an opaque cover and clumps of dust. Both are far out
// of focus: a pixel sees the pupil's disc projected onto the window, and gets the share of it that
// is free. In the image the window is thus blurred by a disc of f * pupil / distance pixels.
// Equations and sources: docs/reference/images.md.
#pragma once

#include "render/stereo_renderer.h"

namespace dockyard {

/// Diameter of that disc [px]. The angle of a place on the window is taken as small.
double WindowBlur_px(const Camera& camera, const WindowOptions& window);

/// How far the cover's edge lies from the image's middle [px], along the way to the cover's side.
/// Beyond it lies the cover's share of the image.
double CoverEdge_px(const Camera& camera, const WindowOptions& window);

/// Each pixel's free share of the pupil; dust alone and cover alone. A flat field's mean becomes 1
/// less the share.
std::vector<float> DustTransmission(const Camera& camera, const WindowOptions& window);
std::vector<float> CoverTransmission(const Camera& camera, const WindowOptions& window);

/// Checks that the options are a window's.
void CheckWindow(const WindowOptions& window);

/// Dims the ideal view by cover and dust, and veils it by the light that the dust scatters. Leaves
/// a view behind a clean window as it is.
void ApplyWindow(const Camera& camera, const WindowOptions& window, RadianceImage& image);

}  // namespace dockyard
