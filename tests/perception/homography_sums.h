// Residuals of a homography over the marks of one image: the paper's measure of its correspondence
// (Tsai et al., III-A.3: "image reprojection error", 8.21 +- 2.4 px, "approximately 1
// pixel/fiducial").
#pragma once

#include <array>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/io/belief.h"

namespace dockyard::axel {

/// Distances between marks and the board's model through the best homography, added up.
struct HomographySum {
  int marks = 0;
  double raw_px = 0.0;     // between the board and raw pixels, as in the paper
  double linear_px = 0.0;  // the lens taken out by the calibration first: an undistorted image
};

/// Left, right; none where there are fewer than five marks, for four leave nothing.
std::array<HomographySum, 2> HomographySums(const SightingReport& report,
                                            const StereoRig& calibration,
                                            const FiducialBoard& board);

/// "raw 7.9 +- 2.1 px, 1.1 a mark; ..." over images with at least six marks.
std::string SumsText(const std::vector<HomographySum>& sums);

}  // namespace dockyard::axel
