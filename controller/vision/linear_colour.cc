#include "controller/vision/linear_colour.h"

#include <array>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

std::array<float, 256> LinearOfByte() {
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const double v = static_cast<double>(i) / 255.0;
    linear[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return linear;
}

const std::array<float, 256>& Linear() {
  static const std::array<float, 256> linear = LinearOfByte();
  return linear;
}

}  // namespace

Eigen::Vector3f LinearAt(const RgbImage& image, int x, int y) {
  const std::uint8_t* p =
      &image.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x))];
  return {Linear()[p[0]], Linear()[p[1]], Linear()[p[2]]};
}

PairImage ToLinearPairs(const RgbImage& image) {
  DOCKYARD_CHECK(image.pixels.size() == 3 * static_cast<std::size_t>(image.width) *
                                            static_cast<std::size_t>(image.height));
  const std::array<float, 256>& linear = Linear();
  PairImage out{image.width / 2, image.height, {}};
  out.pairs.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int j = 0; j < out.height; ++j) {
    const std::uint8_t* p =
        &image.pixels[3 * static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width)];
    for (int i = 0; i < out.width; ++i, p += 6) {
      out.pairs.emplace_back(0.5f * (linear[p[0]] + linear[p[3]]),
                             0.5f * (linear[p[1]] + linear[p[4]]),
                             0.5f * (linear[p[2]] + linear[p[5]]));
    }
  }
  return out;
}

}  // namespace dockyard
