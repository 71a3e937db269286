// Regions of one colour in an image. OpenCV stays behind the .cc file.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/hsv_band.h"
#include "controller/geometry/image.h"
#include "controller/vision/ellipse.h"

namespace dockyard {

/// The bounding region of a blob, its sides parallel to the image's: the pixels' outer edges, half
/// a pixel beyond their centres.
struct BlobBounds {
  double left_px = 0.0, top_px = 0.0, right_px = 0.0, bottom_px = 0.0;

  double width_px() const { return right_px - left_px; }
  double height_px() const { return bottom_px - top_px; }
  double area_px2() const { return width_px() * height_px(); }
  Eigen::Vector2d centre_px() const {
    return {0.5 * (left_px + right_px), 0.5 * (top_px + bottom_px)};
  }
};

/// Pixels of one band that touch each other, corners included.
struct ColourBlob {
  double area_px2 = 0.0;  // pixels
  BlobBounds bounds;
  Ellipse ellipse;  // with the blob's second moments, each pixel a square
};

/// A colour in the terms of HsvBand.
struct Hsv {
  std::uint8_t hue = 0, saturation = 0, value = 0;
};

/// Each pixel of the image as hue, saturation and value, row by row.
std::vector<Hsv> ToHsv(const RgbImage& image);

/// Whether the colour lies in the band.
bool Within(const Hsv& colour, const HsvBand& band);

/// An image in hue, saturation and value, to be searched with one band after another.
class ColourSearch {
 public:
  explicit ColourSearch(const RgbImage& image);
  /// The blobs of at least that many pixels, in the order of their first pixels.
  std::vector<ColourBlob> Blobs(const HsvBand& band, double least_area_px2) const;

  int width() const { return width_; }
  int height() const { return height_; }
  const Hsv& At(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }

 private:
  int width_ = 0, height_ = 0;
  std::vector<Hsv> pixels_;
};

}  // namespace dockyard
