// Heights of the ground from a stereo pair.
#pragma once

#include <vector>

#include "controller/stereo/match.h"

namespace dockyard {

/// Frame E on a plane: the rig's origin brought down on it, z along its normal, x along the rig's x
/// axis, as far as that lies in the plane. Throws std::invalid_argument for a plane that faces
/// ahead.
Pose3 FrameOn(const Plane& ground_R);

/// Heights over a plane.
struct ElevationMap {
  Pose3 X_RE;                                   // FrameOn of the plane
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;  // middle of the first cell
  int nx = 0, ny = 0;
  // By cell, iy * nx + ix; NaN without points.
  std::vector<float> height_m, sigma_m;
  std::vector<int> points;
};

struct ElevationSettings {
  double cell_m = 5e-3;
  double x_low_m = 0.0, x_high_m = 1.5, y_low_m = -0.75, y_high_m = 0.75;  // in E
  double disparity_sigma_px = 0.25;  // of one pixel (JPL's usual figure; NPO-42487 measured 0.32)
};

/// The median of the points in each cell. Its sigma: that of one point's height by its disparity, a
/// cell's points taken as one where their blocks overlap, and the slope within a cell.
ElevationMap MapHeights(const RectifiedPair& pair, const Disparities& disparities,
                        const Plane& ground_R, int block_px, const ElevationSettings& settings);

}  // namespace dockyard
