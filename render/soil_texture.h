// A tileable texture of desert soil: grain, lumps and pebbles, the same for the same seed.
#pragma once

#include <cstdint>
#include <vector>

#include "render/scene.h"

namespace dockyard {

/// side x side texels of four bytes over kSoilTile_m: brightness (128 = mean), slope along x, slope
/// along y (128 = level, 127 steps = kSoilSlopeFull), height.
inline constexpr int kSoilSide = 1024;
inline constexpr double kSoilTile_m = 1.6;
inline constexpr double kSoilSlopeFull = 1.5;

/// Seed 0: level and even, no grain at all.
/// Pebbles with a longer half side above largest_pebble_m are left out; the others stay.
std::vector<std::uint8_t> SoilTexture(std::uint64_t seed, double largest_pebble_m = kAllPebbles_m);

/// The same texture at kLumpSide texels a side, for tone over wide ground.
inline constexpr int kLumpSide = 64;
std::vector<std::uint8_t> SoilLumps(const std::vector<std::uint8_t>& soil);

}  // namespace dockyard
