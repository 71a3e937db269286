// An image as analogue video through a frame grabber: jitter of the lines, noise, quantisation.
// No GL.
#pragma once

#include <cstdint>
#include <vector>

#include "render/stereo_renderer.h"

namespace dockyard {

/// Whether the signal reaches the converter as it leaves the sensor.
inline bool IsDirect(const VideoOptions& video) {
  return video.noise_share == 0.0 && video.line_jitter_px == 0.0;
}

/// The streams of one image: of its lines, and of its noise. The three images of a colour camera
/// share their lines.
struct VideoKeys {
  std::uint64_t lines = 0, noise = 0;
};

/// The signal [electrons] of rows of `width` pixels, as a frame grabber of `bits` gives it. It is
/// cut off at the full well, each line is shifted along the row by a normal number (linear between
/// pixels; the outermost ones go on), and noise is added.
std::vector<std::uint16_t> Grabbed(const std::vector<float>& signal_e, int width,
                                   double full_well_e, int bits, const VideoOptions& video,
                                   const VideoKeys& keys);

}  // namespace dockyard
