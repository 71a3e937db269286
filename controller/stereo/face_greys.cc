#include "controller/stereo/face_greys.h"

#include <opencv2/imgproc.hpp>

namespace dockyard {
namespace {

// Greys of a face, and the least of another surface, in sigmas of the face's. Assumed, 2-3 and 4-6.
constexpr double kOfFace = 2.5, kOfAnother = 5.0;
// Side of what smoothing mixes at a surface's edge: three sigmas to either side. Assumed, 5-9 px.
constexpr int kMixes_px = 7;

cv::Mat Within(const cv::Mat& greys, const cv::Scalar& mean, const cv::Scalar& most_off) {
  cv::Mat within;
  cv::inRange(greys, mean - most_off, mean + most_off, within);
  return within;
}

}  // namespace

std::optional<cv::Mat> OwnGreys(const cv::Mat& greys, const cv::Mat& on_face,
                                double least_contrast) {
  const int half = greys.cols / 2, inner = half / 2;
  const cv::Rect middle(half - inner, half - inner, 2 * inner + 1, 2 * inner + 1);
  cv::Scalar mean, sigma;
  cv::meanStdDev(greys(middle), mean, sigma, on_face(middle));
  if (sigma[0] < least_contrast) return std::nullopt;
  cv::Mat unmixed;
  cv::erode(Within(greys, mean, kOfAnother * sigma), unmixed,
            cv::getStructuringElement(cv::MORPH_ELLIPSE, {kMixes_px, kMixes_px}));
  return Within(greys, mean, kOfFace * sigma) & on_face & unmixed;
}

}  // namespace dockyard
