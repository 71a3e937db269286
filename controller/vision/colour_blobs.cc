#include "controller/vision/colour_blobs.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "controller/base/check.h"

namespace dockyard {
namespace {

/// Sums over the pixels of one blob.
struct Sums {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  int left = 0, top = 0, right = -1, bottom = -1;

  void Add(int column, int row) {
    left = count == 0.0 ? column : std::min(left, column);
    right = count == 0.0 ? column : std::max(right, column);
    top = count == 0.0 ? row : top;
    bottom = row;
    const double u = column, v = row;
    count += 1.0;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
    yy += v * v;
  }
};

// A disc of radius a has variance a^2/4 along each axis. A pixel is a square, with 1/12 of its own.
Ellipse EllipseOf(const Sums& sums) {
  const Eigen::Vector2d centre(sums.x / sums.count, sums.y / sums.count);
  Eigen::Matrix2d covariance;
  covariance << sums.xx, sums.xy, sums.xy, sums.yy;
  covariance =
      covariance / sums.count - centre * centre.transpose() + Eigen::Matrix2d::Identity() / 12.0;
  // Square root of a positive 2 x 2 matrix (Cayley-Hamilton).
  const double root = std::sqrt(std::max(covariance.determinant(), 0.0));
  const Eigen::Matrix2d shape = 2.0 * (covariance + root * Eigen::Matrix2d::Identity()) /
                                std::sqrt(covariance.trace() + 2.0 * root);
  return {.centre_px = centre, .shape_px = shape};
}

ColourBlob BlobOf(const Sums& sums) {
  return {.area_px2 = sums.count,
          .bounds = {.left_px = sums.left - 0.5,
                     .top_px = sums.top - 0.5,
                     .right_px = sums.right + 0.5,
                     .bottom_px = sums.bottom + 0.5},
          .ellipse = EllipseOf(sums)};
}

}  // namespace

std::vector<Hsv> ToHsv(const RgbImage& image) {
  DOCKYARD_CHECK(image.pixels.size() == 3 * static_cast<std::size_t>(image.width) *
                                            static_cast<std::size_t>(image.height));
  // One thread, whatever the machine: a static of the function's own, set once.
  [[maybe_unused]] static const bool single = (cv::setNumThreads(1), true);
  std::vector<Hsv> pixels(image.pixels.size() / 3);
  if (pixels.empty()) return pixels;
  const cv::Mat rgb(image.height, image.width, CV_8UC3,
                    const_cast<std::uint8_t*>(image.pixels.data()));  // only read
  cv::Mat hsv;
  cv::cvtColor(rgb, hsv, cv::COLOR_RGB2HSV);
  for (int y = 0; y < hsv.rows; ++y) {
    const cv::Vec3b* row = hsv.ptr<cv::Vec3b>(y);
    Hsv* out = pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(hsv.cols);
    for (int x = 0; x < hsv.cols; ++x) out[x] = {row[x][0], row[x][1], row[x][2]};
  }
  return pixels;
}

bool Within(const Hsv& colour, const HsvBand& band) {
  const bool hue = band.hue_from <= band.hue_to
                       ? colour.hue >= band.hue_from && colour.hue <= band.hue_to
                       : colour.hue >= band.hue_from || colour.hue <= band.hue_to;
  return hue && colour.saturation >= band.saturation_from &&
         colour.saturation <= band.saturation_to && colour.value >= band.value_from &&
         colour.value <= band.value_to;
}

ColourSearch::ColourSearch(const RgbImage& image)
    : width_(image.width), height_(image.height), pixels_(ToHsv(image)) {}

std::vector<ColourBlob> ColourSearch::Blobs(const HsvBand& band, double least_area_px2) const {
  if (pixels_.empty()) return {};
  cv::Mat inside(height_, width_, CV_8U), labels;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) inside.at<std::uint8_t>(y, x) = Within(At(x, y), band);
  }
  const int count = cv::connectedComponents(inside, labels, 8, CV_32S);
  std::vector<Sums> sums(static_cast<std::size_t>(count));
  std::vector<int> order;  // of the labels, by first pixel
  for (int y = 0; y < height_; ++y) {
    const int* row = labels.ptr<int>(y);
    for (int x = 0; x < width_; ++x) {
      if (row[x] == 0) continue;
      Sums& one = sums[static_cast<std::size_t>(row[x])];
      if (one.count == 0.0) order.push_back(row[x]);
      one.Add(x, y);
    }
  }
  std::vector<ColourBlob> blobs;
  for (const int label : order) {
    const Sums& one = sums[static_cast<std::size_t>(label)];
    if (one.count >= least_area_px2) blobs.push_back(BlobOf(one));
  }
  return blobs;
}

}  // namespace dockyard
