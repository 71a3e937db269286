// The turn between a colour camera's image and its flat views. No GL.
#pragma once

#include <cmath>
#include <vector>

#include "render/flat_view.h"
#include "render/pixel_row.h"

namespace dockyard {

/// Views of colour cameras are rolled against the image by this angle, and the rays with them: else
/// an edge along the pixels' rows would move by whole distances of rays. Its tangent, the square of
/// the golden section, keeps rays from lying in line with one another.
inline constexpr double kViewTurn_rad = 0.364864;

/// Between the tan plane of the image and that of its views.
struct ViewTurn {
  float c = static_cast<float>(std::cos(kViewTurn_rad));
  float s = static_cast<float>(std::sin(kViewTurn_rad));

  Tan ToView(Tan t) const { return {c * t.x + s * t.y, -s * t.x + c * t.y}; }
  Tan ToImage(Tan t) const { return {c * t.x - s * t.y, s * t.x + c * t.y}; }
  /// x and y of many at once.
  void ToView(const std::vector<float>& x, const std::vector<float>& y, std::vector<float>& to_x,
              std::vector<float>& to_y) const {
    for (std::size_t i = 0; i < x.size(); ++i) to_x[i] = c * x[i] + s * y[i];
    for (std::size_t i = 0; i < x.size(); ++i) to_y[i] = c * y[i] - s * x[i];
  }
  void ToView(const PixelRow& row, PixelRow& to) const {
    ToView(row.x, row.y, to.x, to.y);
    ToView(row.along_x, row.along_y, to.along_x, to.along_y);
    ToView(row.down_x, row.down_y, to.down_x, to.down_y);
    to.number = row.number;
  }
};

}  // namespace dockyard
