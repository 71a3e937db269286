// Pictures that are no 8-bit grey image, as PNG: with more bits, or in colour.
#pragma once

#include <array>
#include <string>

#include "render/stereo_renderer.h"

namespace dockyard {

/// 16-bit grey, the numbers as the converter gave them (0 to 2^bits - 1).
std::string EncodePng(const DeepImage& image);
/// Red, green, blue of one eye, linear; 8 bits a channel, or 16 as above when there are more
/// than 8.
std::string EncodePng(const std::array<DeepImage, 3>& rgb);

}  // namespace dockyard
