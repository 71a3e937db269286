// The same scene by rays: exact lens, true triangles, sun as a disc. Shares neither rasteriser, nor
// shadow map, nor warp, nor ink code with the renderer.
#pragma once

#include "render/scene.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Grey radiance of one view; rays_a_side^2 rays a pixel, one point of the sun for each. Ground
/// without grain (texture_seed 0).
RadianceImage CastRays(const Scene& scene, const Camera& camera, const Pose3& X_WC,
                       int rays_a_side);

}  // namespace dockyard
