// Images as PNG files' bytes, and back.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "controller/geometry/image.h"

namespace dockyard {

/// 8 bits a channel. The image has at least one pixel.
std::string EncodePng(const GrayImage& image);
std::string EncodePng(const RgbImage& image);
/// 16-bit grey, the numbers as the converter gave them (0 to 2^bits - 1).
std::string EncodePng(const DeepImage& image);
/// Red, green, blue of one camera, linear; 8 bits a channel, or 16 as above when there are more
/// than 8.
std::string EncodePng(const std::array<DeepImage, 3>& rgb);

/// GrayImage or RgbImage, as EncodePng wrote it; none when the bytes are another PNG or none, or
/// one of more than kMaxImagePixels. decode.h reads all kinds.
template <class Image>
std::optional<Image> DecodePng(std::string_view bytes);

/// Equal red, green and blue.
RgbImage AsColour(const GrayImage& image);
/// GrayImage as equal red, green and blue, or RgbImage, as EncodePng wrote it; else none.
std::optional<RgbImage> ColourFromPng(std::string_view bytes);

}  // namespace dockyard
