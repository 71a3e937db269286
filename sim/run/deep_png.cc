#include "sim/run/deep_png.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "controller/base/check.h"

namespace dockyard {
namespace {

std::string Encode(const cv::Mat& image) {
  std::vector<std::uint8_t> png;
  DOCKYARD_CHECK(cv::imencode(".png", image, png));
  return {reinterpret_cast<const char*>(png.data()), png.size()};
}

cv::Mat View(const DeepImage& image) {
  return {image.height, image.width, CV_16UC1, const_cast<std::uint16_t*>(image.pixels.data())};
}

}  // namespace

std::string EncodePng(const DeepImage& image) { return Encode(View(image)); }

std::string EncodePng(const std::array<DeepImage, 3>& rgb) {
  const std::vector<cv::Mat> planes{View(rgb[2]), View(rgb[1]), View(rgb[0])};  // OpenCV's order
  cv::Mat colour;
  cv::merge(planes, colour);
  if (rgb[0].bits == 8) colour.convertTo(colour, CV_8UC3);
  return Encode(colour);
}

}  // namespace dockyard
