// Slopes of the height grid and its own shadow, at the grid's full resolution. They are kept from
// image to image: when a wheel has changed a few heights, only the cells that these reach are made
// anew. Plain arithmetic, no GL.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/scene.h"

namespace dockyard {

/// Columns x_begin to x_end - 1 of rows y_begin to y_end - 1.
struct GridRect {
  int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;
  bool empty() const { return x_begin >= x_end || y_begin >= y_end; }
};

/// Where a height grid lies, and how large it is.
struct GridPlace {
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;
  int nx = 0, ny = 0;
  bool operator==(const GridPlace&) const = default;
};
GridPlace PlaceOf(const GroundView& ground);

class GroundRelief {
 public:
  /// Takes the ground and the sun as they are now. sun_G: unit, towards the sun. The cells that may
  /// differ from those before are in the answer; the cells are those of a fresh object, to the bit.
  GridRect Update(const GroundView& ground, const Eigen::Vector3d& sun_G,
                  double sun_angular_diameter_rad);

  /// In the middle of a cell, one of (nx - 1) x (ny - 1).
  struct Cell {
    float slope_x = 0.0f, slope_y = 0.0f,
          sun_share = 0.0f;  // of the sun, left by the ground itself
  };
  Cell At(int column, int row) const;
  /// Of the grid.
  double highest_m() const { return highest_m_; }

 private:
  // Nodes towards the sun and how high the ray to the sun's centre is over each of them.
  struct March {
    std::vector<int> dx, dy;
    std::vector<double> rise_m, distance_m;
  };
  static March MarchToSun(double cell_m, const Eigen::Vector3d& sun_G, double relief_m);
  double SunShare(int ix, int iy) const;
  GridRect ChangedNodes(const double* heights_m) const;
  /// The nodes whose ray to the sun passes over one of these.
  GridRect InTheirShadow(const GridRect& nodes) const;

  GridPlace place_;
  Eigen::Vector3d sun_G_{0, 0, 0};
  double sun_diameter_rad_ = 0.0;
  double sun_rise_ = 0.0;  // height of the disc's radius over a level metre; see ground_horizon.cc
  double highest_m_ = 0.0;
  March march_;
  std::vector<double> heights_m_;
  std::vector<float> shares_;  // of the sun, per node
};

}  // namespace dockyard
