// An image as OpenCV's matrix.
#pragma once

#include <opencv2/core.hpp>

#include "controller/geometry/image.h"

namespace dockyard {

/// On the image's own pixels, which it must not outlive. Writing to it writes to them.
inline cv::Mat MatOn(const GrayImage& image) {
  // One thread, whatever the machine: a static of the function's own, set once.
  [[maybe_unused]] static const bool single = (cv::setNumThreads(1), true);
  return {image.height, image.width, CV_8U, const_cast<std::uint8_t*>(image.pixels.data())};
}

}  // namespace dockyard
