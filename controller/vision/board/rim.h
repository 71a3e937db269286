// The rim of a disc to a fraction of a pixel: edges along rays from its middle, robust ellipse.
#pragma once

#include <optional>

#include "controller/geometry/image.h"
#include "controller/vision/ellipse.h"

namespace dockyard {

struct RimFit {
  Ellipse ellipse;
  double inlier_share = 0.0;  // of the rays
  double rms_px = 0.0;        // of the inliers
};

/// Fits the start (right to about a quarter of its size) to the disc's edge. A shadow's edge, a
/// tether or an arm across part of the rim is left out as an outlier. None when too few rays agree
/// on an ellipse.
std::optional<RimFit> RefineRim(const GrayImage& image, const Ellipse& start);

}  // namespace dockyard
