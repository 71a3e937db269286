// Which part of an image deserves a denser view, and how many rays a view gets.
#pragma once

#include <optional>

#include "render/fisheye_warp.h"
#include "render/flat_view.h"
#include "render/scene.h"

namespace dockyard {

/// Sets rect and size: `density` rays per image pixel along either side, fewer beyond most_pixels.
void SizeView(const Camera& camera, const TanRect& rect, double density, double most_pixels,
              FlatView& view);

/// The scene's point of interest, else the board that fills most of the image, in the tan plane,
/// cut to the image; none when it does not lie wholly before the camera or lies outside the image.
std::optional<TanRect> CloseRect(const Scene& scene, const Pose3& X_WC, const TanRect& image);

}  // namespace dockyard
