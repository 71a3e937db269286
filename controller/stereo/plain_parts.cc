#include "controller/stereo/plain_parts.h"

#include <limits>
#include <opencv2/imgproc.hpp>

#include "controller/base/check.h"
#include "controller/stereo/gray_mat.h"

namespace dockyard {

Disparities WithoutPlainParts(Disparities disparities, const GrayImage& left,
                              const PlainSettings& settings) {
  DOCKYARD_CHECK(disparities.width == left.width && disparities.height == left.height);
  cv::Mat grey, mean, square;
  MatOn(left).convertTo(grey, CV_32F);
  // A third of the sensor's noise is left.
  cv::blur(grey, grey, {3, 3});
  const cv::Size about(settings.about_px, settings.about_px);
  cv::blur(grey, mean, about);
  cv::blur(grey.mul(grey), square, about);
  const double least = settings.least_contrast * settings.least_contrast;
  for (int v = 0; v < left.height; ++v) {
    for (int u = 0; u < left.width; ++u) {
      const double m = mean.at<float>(v, u);
      if (square.at<float>(v, u) - m * m >= least) continue;
      disparities.px[static_cast<std::size_t>(v) * static_cast<std::size_t>(left.width) +
                     static_cast<std::size_t>(u)] = std::numeric_limits<float>::quiet_NaN();
    }
  }
  return disparities;
}

}  // namespace dockyard
