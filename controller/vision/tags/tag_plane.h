// Internal to the tags room. The plane in which a tag's edges are straight, and the tag in it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/geometry/camera.h"
#include "controller/vision/homography.h"

namespace dockyard {

using TagCorners = std::array<Eigen::Vector2d, 4>;

/// Before a lens: the tangent plane of the viewing sphere at the tag, in units of a pixel there.
/// Without a camera: the image.
class StraightPlane {
 public:
  StraightPlane(const TagCorners& corners_px, const Camera* camera);
  Eigen::Vector2d FromPixel(const Eigen::Vector2d& pixel) const;
  /// None where the lens shows no such point.
  std::optional<Eigen::Vector2d> ToPixel(const Eigen::Vector2d& point) const;

 private:
  const Camera* camera_ = nullptr;
  TangentPlane tangent_{};
  double scale_ = 1.0;
};

/// From a tag's cells, about its middle, to the plane.
/// @param at_border  TagCells::at_border
std::optional<Eigen::Matrix3d> FromCells(const TagCorners& corners, int at_border);

}  // namespace dockyard
