// GLSL sources. They tell what each ray sees as flat_view.h says. Light axes U: z towards the sun,
// lengths in metres.
#pragma once

#include <string>

namespace dockyard {

/// Positions alone, and with normals and coverage.
std::string PlainVertexShader();
std::string SurfaceVertexShader();
std::string ObjectFragmentShader();
std::string GroundFragmentShader();
std::string BoardFragmentShader();
/// Of bodies thinner than the rays are apart.
std::string ThinFragmentShader();
std::string DepthFragmentShader();

}  // namespace dockyard
