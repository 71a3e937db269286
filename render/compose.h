// From flat views to the lens's image: each pixel takes the hits of the rays within its exact
// footprint, and shades ground, boards and sky where it points itself. Plain arithmetic, no GL.
#pragma once

#include <array>
#include <vector>

#include "render/colour_table.h"
#include "render/pixel_row.h"
#include "render/radiance_image.h"
#include "render/scene_shader.h"

namespace dockyard {

/// close may be null; it is used where it holds the whole footprint.
RadianceImage Compose(const PixelGrid& grid, const FlatView& wide, const FlatView* close,
                      const Lit& lit, const Pose3& X_WC, Channel channel, bool with_depth);

/// Pixels first to last - 1 of a row.
struct PixelSpan {
  int first = 0, last = 0;
};

/// Rays a side of a colour camera's pixel that are asked for in a view; views should have as many a
/// pixel.
inline constexpr int kWideRays = 2, kCloseRays = 4;

/// Adds the radiance of each row's span to the three images, red, green, blue, of the grid's size.
/// The views are rolled by kViewTurn_rad about the camera's axis, X_WC is not.
void ComposeColour(const PixelGrid& grid, const std::vector<PixelSpan>& spans, const FlatView& wide,
                   const FlatView* close, int close_rays, const Lit& lit,
                   const ColourTable& colours, const Pose3& X_WC,
                   std::array<RadianceImage, 3>& sum);

}  // namespace dockyard
