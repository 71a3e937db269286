// Portable float maps: one number of 32 bits a pixel, as Middlebury's stereo data have them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

/// Row by row from the top left.
struct FloatImage {
  int width = 0, height = 0;  // [px]
  std::vector<float> pixels;
  bool operator==(const FloatImage&) const = default;
};

/// Grey, the lower byte first; in the file the bottom row is first. NaN is written as infinity,
/// which means no value.
std::string EncodePfm(const FloatImage& image);
/// Grey, either byte order; none for other bytes, a file that ends early, or more than
/// kMaxImagePixels. Infinity is kept.
std::optional<FloatImage> DecodePfm(std::string_view bytes);

}  // namespace dockyard
