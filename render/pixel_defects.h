// Hot and dead pixels: a pure function of the pattern's key and the pixel. No GL.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/stereo_renderer.h"

namespace dockyard {

/// Of the hot pixels, those that add an offset to every image: over 40 % (Thomas et al., Proc. SPIE
/// 7875, 2011).
inline constexpr double kStuckShare = 0.4;

inline bool HasDefects(const DefectOptions& defects) {
  return defects.hot_share > 0.0 || defects.dead_share > 0.0;
}

/// The electrons of `count` pixels from `first` on, with the dark signal of the hot ones, and
/// without the light of the dead ones. pattern: the stream of one camera.
void AddDefects(const DefectOptions& defects, std::uint64_t pattern, std::size_t first,
                std::size_t count, float* electrons);

}  // namespace dockyard
