// An 8-bit grey image, row by row from the top left, without padding.
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

struct StereoImages {
  GrayImage left, right;
  bool operator==(const StereoImages&) const = default;
};

}  // namespace dockyard
