// GLSL sources. They give the hit of each ray as in flat_view.h. Light axes U: z towards the sun,
// lengths in metres.
#pragma once

#include <string>

#include "render/flat_view.h"

namespace dockyard {

/// Positions alone, and with normals and coverage.
std::string PlainVertexShader();
std::string SurfaceVertexShader();
std::string ObjectFragmentShader(HitBits bits);
std::string GroundFragmentShader();
std::string BoardFragmentShader();
/// Of bodies thinner than the rays are apart.
std::string ThinFragmentShader();
std::string DepthFragmentShader();

}  // namespace dockyard
