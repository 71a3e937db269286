// GLSL sources. All shading happens in light axes U: z towards the sun, lengths in metres.
#pragma once

#include <string>

namespace dockyard {

inline constexpr int kMaxFiducials = 32;
/// Side of a shadow tile in texels, and how many tiles round a place its bounds cover.
inline constexpr int kShadowTile = 8;
inline constexpr int kShadowReachTiles = 2;

std::string SurfaceVertexShader();
std::string SurfaceFragmentShader();
/// Without shadows for ground that no caster stands over.
std::string GroundFragmentShader(bool shadows);
std::string BoardFragmentShader();
std::string SkyVertexShader();
std::string SkyFragmentShader();
std::string DepthVertexShader();
std::string DepthFragmentShader();
std::string FullScreenVertexShader();
/// Highest and lowest caster in each tile of the shadow map; then over the tiles around.
std::string TileBoundsFragmentShader();
std::string TileSpreadFragmentShader();

}  // namespace dockyard
