// Internal to the tags room. The known pattern of a tag laid over an image by least squares.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"

namespace dockyard {

struct TagFit {
  std::array<Eigen::Vector2d, 4> corners;  // as CornersOf
  double sigma_px = 0.0;                   // of a corner, one axis, from the residuals
};

/// @param corners  near the true ones, to a pixel or so
/// @param camera   with it, edges are straight before the lens; null: in the image
/// None when the image does not show that pattern there.
std::optional<TagFit> FitTag(const GrayImage& image, const TagCells& cells,
                             const std::array<Eigen::Vector2d, 4>& corners, const Camera* camera);

/// What the image shows in the middle of each square.
struct CellReading {
  int wrong = 0;        // squares on the other side of the threshold than printed
  double margin = 0.0;  // mean distance of the grey levels from the threshold
};
CellReading ReadCells(const GrayImage& image, const TagCells& cells,
                      const std::array<Eigen::Vector2d, 4>& corners);

}  // namespace dockyard
