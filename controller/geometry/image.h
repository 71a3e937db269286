// Images, row by row from the top left, without padding.
#pragma once

#include <cstdint>
#include <vector>

namespace dockyard {

struct GrayImage {
  int width = 0, height = 0;         // [px]
  std::vector<std::uint8_t> pixels;  // width * height

  std::uint8_t at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
  bool operator==(const GrayImage&) const = default;
};

/// Red, green, blue, three bytes a pixel: linear, or with the transfer curve of sRGB where the
/// camera that took it has one (render/colour_sensor.h).
struct RgbImage {
  int width = 0, height = 0;         // [px]
  std::vector<std::uint8_t> pixels;  // 3 * width * height

  bool operator==(const RgbImage&) const = default;
};

/// An image as the converter gave it: 0 to 2^bits - 1.
struct DeepImage {
  int width = 0, height = 0, bits = 8;
  std::vector<std::uint16_t> pixels;  // row by row from the top left
  bool operator==(const DeepImage&) const = default;
};

struct StereoImages {
  GrayImage left, right;
  bool operator==(const StereoImages&) const = default;
};

}  // namespace dockyard
