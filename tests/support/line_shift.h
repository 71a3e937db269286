// By how far the lines of an image are off those of another.
#pragma once

#include "controller/geometry/image.h"

namespace dockyard {

/// How far [px] the rows first, first + step ... below `end` of an image show things to the right
/// of where another image of the same size shows them: by least squares over that one's slopes.
inline double ShiftOfRows_px(const GrayImage& image, const GrayImage& from, int first, int end,
                             int step = 1) {
  double product = 0.0, square = 0.0;
  for (int y = first; y < end; y += step) {
    for (int x = 1; x + 1 < image.width; ++x) {
      const double slope = 0.5 * (from.at(x + 1, y) - from.at(x - 1, y));
      product += slope * (from.at(x, y) - image.at(x, y));
      square += slope * slope;
    }
  }
  return product / square;
}

/// How far [px] every other line of an image, from the first given one on, shows things to the
/// right of where another image of the same size shows them: by least squares over that one's
/// slopes.
inline double ShiftOfLines_px(const GrayImage& image, const GrayImage& from, int first) {
  return ShiftOfRows_px(image, from, first, image.height, 2);
}

}  // namespace dockyard
