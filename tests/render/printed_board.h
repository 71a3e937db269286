// A board with patterns of black and white squares on it, such as AprilTags, as the renderer sees
// it: for comparisons only, the renderer itself draws discs.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "render/stereo_renderer.h"

namespace dockyard {

/// A square pattern printed on the board's face; its rows run along the board's x axis.
struct PrintedImage {
  Eigen::Vector2d p_BM{0, 0};  // its middle [m]
  double module_m = 0.0;       // side of one square
  int modules = 0;             // a side
  std::vector<bool> black;     // row by row from the top left

  bool IsBlack(int column, int row) const {
    return black[static_cast<std::size_t>(row * modules + column)];
  }
};

/// Share of a pixel's footprint that the pattern's ink covers: areas of polygons, exact for a plane
/// footprint. corners_B go round it.
double InkShare(const PrintedImage& print, const std::array<Eigen::Vector2d, 4>& corners_B);

/// Both ideal views with the patterns in the fiducials' place. The renderer draws the plate once
/// all white, once all black; a pixel lies between the two by its share of ink. Light, shadow,
/// dust, occlusion and the board's edges are thus the renderer's.
std::array<RadianceImage, 2> RenderPrinted(StereoRenderer& renderer, const Scene& scene,
                                           const StereoRig& rig, const Pose3& X_WR,
                                           const std::vector<PrintedImage>& prints);

}  // namespace dockyard
