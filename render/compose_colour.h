// From flat views to a colour image in one pass: each pixel's share of every light, times the
// colours of the materials in these lights. Plain arithmetic, no GL.
#pragma once

#include <array>
#include <vector>

#include "render/colour_table.h"
#include "render/ground_texture.h"
#include "render/pixel_row.h"
#include "render/scene.h"
#include "render/stereo_renderer.h"
#include "render/sun_shadow.h"

namespace dockyard {

/// The parts of an image beside the views. The shadow is that of the scene.
struct ColourLit {
  const Scene& scene;
  const GroundTexture& ground;
  const SunShadow& shadow;
  const ColourTable& colours;
};

/// Pixels first to last - 1 of a row.
struct PixelSpan {
  int first = 0, last = 0;
};

/// Rays a side of a pixel that are asked for in a view; views should have as many a pixel.
inline constexpr int kWideRays = 2, kCloseRays = 4;

/// Adds the radiance of each row's span to the three images, red, green, blue, of the grid's size.
/// The views are rolled by kViewTurn_rad about the camera's axis, X_WC is not. close may be null;
/// it is used where it holds the whole footprint. Boards are not drawn.
void ComposeColour(const PixelGrid& grid, const std::vector<PixelSpan>& spans, const FlatView& wide,
                   const FlatView* close, const ColourLit& lit, const Pose3& X_WC,
                   std::array<RadianceImage, 3>& sum);

}  // namespace dockyard
