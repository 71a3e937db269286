// Internal to the vision room, like every header with OpenCV in it. Adaptive threshold, connected
// regions and the filters on them (Tsai et al., III-A.2 and Fig. 5).
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/vision/ellipse.h"

namespace dockyard {

/// One level of the image pyramid: everything is 2^level times smaller than the image.
struct BlobLevel {
  int level = 0;
  cv::Mat gray;  // 8 bit
  cv::Mat flat;  // 8 bit: kFlatWhite times the grey over the white that surrounds it
  double scale() const { return static_cast<double>(1 << level); }
  /// A pixel of this level in the image, and a pixel of the image in this level.
  Eigen::Vector2d ToImage(const Eigen::Vector2d& at) const {
    return scale() * (at + Eigen::Vector2d(0.5, 0.5)) - Eigen::Vector2d(0.5, 0.5);
  }
  Eigen::Vector2d FromImage(const Eigen::Vector2d& at) const {
    return (at + Eigen::Vector2d(0.5, 0.5)) / scale() - Eigen::Vector2d(0.5, 0.5);
  }
};
inline constexpr int kFlatWhite = 200;

/// A dark region that may be a fiducial, in pixels of its level.
struct Blob {
  Ellipse moments;         // the ellipse with its second moments, holes filled
  double threshold = 0.0;  // dark over light, at which it was found
};

/// The ellipse with an outline's moments; the outline runs through pixel centres, half a pixel
/// inside the region. None when it encloses next to nothing.
std::optional<Ellipse> MomentEllipse(const cv::Moments& moments);
bool FitsInside(const Ellipse& ellipse, const cv::Size& size);

/// Pyramid of the image with the light divided out. The light is estimated by a grey closing, which
/// fills dark regions smaller than its window but keeps the straight edge of a shadow.
std::vector<BlobLevel> BuildLevels(const GrayImage& image);

/// Regions of one level, at several thresholds, that pass the filters on size, eccentricity, Euler
/// number, coincident black and white centroids, and black/white ratio.
/// @param tile_px  The level is searched in squares of this side, with the same result: the time
///                 that cv::findContours takes grows with the square of the number of outlines,
///                 34 s for 12 megapixels of noise. Images of ordinary cameras are one square.
std::vector<Blob> FindBlobs(const BlobLevel& level, int tile_px = 1280);

}  // namespace dockyard
