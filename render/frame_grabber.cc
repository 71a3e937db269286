#include "render/frame_grabber.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

/// Into `out`: the line's pixels shift_px to the right of each.
void Shift(const float* line, int width, float shift_px, float* out) {
  const float whole = std::floor(shift_px);
  const float part = shift_px - whole;
  const auto first = static_cast<int>(whole);
  const auto at = [&](int x) { return line[std::clamp(x, 0, width - 1)]; };
  for (int x = 0; x < width; ++x) {
    const float left = at(x + first), right = at(x + first + 1);
    out[x] = left + part * (right - left);
  }
}

}  // namespace

std::vector<std::uint16_t> Grabbed(const std::vector<float>& signal_e, int width,
                                   double full_well_e, int bits, const VideoOptions& video,
                                   const VideoKeys& keys) {
  if (signal_e.empty()) return {};
  DOCKYARD_CHECK(width > 0 && signal_e.size() % static_cast<std::size_t>(width) == 0);
  const auto columns = static_cast<std::size_t>(width);
  const auto full = static_cast<float>(full_well_e);
  const auto sigma_e = static_cast<float>(video.noise_share * full_well_e);
  const auto jitter_px = static_cast<float>(video.line_jitter_px);
  const auto most = static_cast<float>((1 << bits) - 1);
  const float levels_per_e = most / full;
  std::vector<std::uint16_t> pixels(signal_e.size());
  std::vector<float> cut(columns), line(columns);
  for (std::size_t first = 0; first < pixels.size(); first += columns) {
    for (std::size_t x = 0; x < columns; ++x) cut[x] = std::min(signal_e[first + x], full);
    Shift(cut.data(), width, jitter_px * HashNormal(keys.lines, first / columns), line.data());
    for (std::size_t x = 0; x < columns; ++x) {
      const float noisy = line[x] + sigma_e * HashNormal(keys.noise, first + x);
      const float level = noisy * levels_per_e + 0.5f;
      pixels[first + x] = static_cast<std::uint16_t>(std::min(std::max(level, 0.0f), most));
    }
  }
  return pixels;
}

}  // namespace dockyard
