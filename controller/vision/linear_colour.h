// A colour image as light again: linear, and in pairs of pixels side by side, as cheap cameras code
// one colour for two.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/image.h"

namespace dockyard {

/// Linear red, green, blue, 0 to 1, of pairs of pixels: pair (i, j) is the mean of the pixels
/// (2i, j) and (2i + 1, j).
struct PairImage {
  int width = 0, height = 0;  // in pairs, in rows
  std::vector<Eigen::Vector3f> pairs;

  const Eigen::Vector3f& At(int i, int j) const {
    return pairs[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(i)];
  }
};

/// Undoes the transfer curve of sRGB (IEC 61966-2-1) in one pixel.
Eigen::Vector3f LinearAt(const RgbImage& image, int x, int y);
/// In all of them.
PairImage ToLinearPairs(const RgbImage& image);

}  // namespace dockyard
