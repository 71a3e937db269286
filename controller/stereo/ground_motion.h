// How a rover moved over the ground, by two pictures of it: parts of the earlier one, seen from
// above, are found again in the later one. It needs no stones, and sees that wheels slip.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/geometry/pose.h"
#include "controller/stereo/elevation.h"
#include "controller/stereo/rectify.h"

namespace dockyard {

/// The ground's greys from above, by cell of a grid on frame E, iy * nx + ix; NaN where the camera
/// does not see the ground.
struct GroundImage {
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;  // middle of the first cell
  int nx = 0, ny = 0;
  std::vector<float> grey{};
  Eigen::Vector3d p_EC{0, 0, 0.3};  // the camera
  double focal_px = 250.0;
};

/// @param left     rectified
/// @param heights  of the ground, gaps closed; what stands higher than highest_m is none
GroundImage FromAbove(const RectifiedPair& pair, const GrayImage& left, const ElevationMap& heights,
                      double highest_m = 0.06);

struct GroundMotionSettings {
  double half_m = 0.04, apart_m = 0.06;  // of a part, and between their middles; assumed, 3-6 cm
  double least_known = 0.9;              // share of a part's cells; assumed, 0.8-1
  double least_score = 0.6;              // of normalised correlation; assumed, 0.5-0.8
  double least_contrast = 1.0;           // grey, one sigma over a part; assumed, 0.5-2
  double most_off_m = 0.08;              // that a prediction may be off; assumed, 5-10 cm
  double agrees = 3.0;                   // sigmas; assumed, 2.5-4
  int least_parts = 8;                   // that agree; assumed, 5-15
  double least_share = 0.4;              // of those found; assumed, 0.3-0.6
  // Of one part: the place of its correlation's peak, pixels, and the ground's height, at 1 m and
  // growing as the distance's square (docs/rocky7.md, merged). Assumed: 0.2-0.5 px and 1-3 mm.
  double sigma_px = 0.3, sigma_up_m = 0.0015;
  // What all parts have in common, one sigma: attitude and calibration. Assumed, 1-3 mm.
  double common_m = 0.002;
};

struct GroundMotion {
  bool found = false;
  Pose2 X_NB;                                           // the earlier E in the later one
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();  // of its place
  int parts = 0, agreeing = 0;
};

/// @param X_NB           as odometry has it
/// @param yaw_sigma_rad  of its heading
GroundMotion MotionBetween(const GroundImage& before, const GroundImage& now, const Pose2& X_NB,
                           double yaw_sigma_rad, const GroundMotionSettings& settings = {});

}  // namespace dockyard
