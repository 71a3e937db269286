// Which share of each cell of a raster convex polygons cover, exactly, and its blur.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace dockyard {

/// A convex polygon; its corners in either order.
struct ConvexPolygon {
  static constexpr int kMost = 40;
  std::array<Eigen::Vector2d, kMost> corners;
  int count = 0;

  void Add(const Eigen::Vector2d& p) {
    if (count < kMost) corners[static_cast<std::size_t>(count++)] = p;
  }
};

/// The convex hull of points (Andrew's monotone chain).
ConvexPolygon HullOf(ConvexPolygon points);

/// Cell (i, j) of the raster spans [i, i + 1] x [j, j + 1] of the polygons' coordinates.
class Coverage {
 public:
  /// Empties it.
  void Reset(int width, int height);
  /// Where polygons overlap their shares add up.
  void Add(const ConvexPolygon& polygon);
  /// Sums the polygons up: from now on values() are shares, 0 to 1.
  void Finish();

  int width() const { return width_; }
  int height() const { return height_; }
  std::vector<float>& values() { return values_; }
  const std::vector<float>& values() const { return values_; }

 private:
  void AddEdge(double x0, double y0, double x1, double y1, double sign);
  void AddSpan(float* row, double xa, double xb, double dy);

  int width_ = 0, height_ = 0;
  std::vector<float> sums_;  // differences along each row until Finish; width + 2 a row
  std::vector<float> values_;
};

/// A Gaussian of that sigma [cells], rows and columns; values outside count as those of the border.
void BlurShares(int width, int height, double sigma_cells, std::vector<float>* values);

}  // namespace dockyard
