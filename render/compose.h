// From flat views to the lens's image: each pixel takes the hits of the rays within its exact
// footprint, and shades ground, board and sky where it points itself. Plain arithmetic, no GL.
#pragma once

#include <vector>

#include "render/ground_texture.h"
#include "render/pixel_row.h"
#include "render/scene.h"
#include "render/shading.h"
#include "render/stereo_renderer.h"
#include "render/sun_shadow.h"

namespace dockyard {

/// The parts of an image beside the views. The shadow is that of the scene.
struct Lit {
  const Scene& scene;
  const GroundTexture& ground;
  const SunShadow& shadow;
};

/// close may be null; it is used where it holds the whole footprint.
RadianceImage Compose(const PixelGrid& grid, const FlatView& wide, const FlatView* close,
                      const Lit& lit, const Pose3& X_WC, Channel channel, bool with_depth);

}  // namespace dockyard
