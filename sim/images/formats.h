// The decoder of each format, for decode.cc. None: the bytes are no whole image of that format, or
// one of too many pixels.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "controller/geometry/image.h"

namespace dockyard {

std::optional<GrayImage> GrayFromPng(std::string_view bytes);
std::optional<GrayImage> GrayFromJpeg(std::string_view bytes);
std::optional<GrayImage> GrayFromPnm(std::string_view bytes);
std::optional<GrayImage> GrayFromWebp(std::string_view bytes);
/// Grey files as equal red, green and blue.
std::optional<RgbImage> RgbFromPng(std::string_view bytes);
std::optional<RgbImage> RgbFromJpeg(std::string_view bytes);
std::optional<RgbImage> RgbFromPnm(std::string_view bytes);
std::optional<RgbImage> RgbFromWebp(std::string_view bytes);

/// BT.601 in 14 bits, rounded.
inline std::uint8_t GrayOf(int red, int green, int blue) {
  return static_cast<std::uint8_t>((4899 * red + 9617 * green + 1868 * blue + 8192) >> 14);
}

/// Of each pixel's red, green and blue.
GrayImage GrayOf(const RgbImage& image);

}  // namespace dockyard
