// The planar pose that the paper falls back on with one camera (Tsai et al., III-B).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/camera.h"

namespace dockyard {

/// One local minimum of the object-space error.
struct PlanarMinimum {
  Pose3 X_CB;
  double error = 0.0;  // sum of squared distances of the points from their lines of sight [m^2]
};

/// Schweighofer and Pinz, "Robust pose estimation from a planar target", IEEE TPAMI 28(12), 2006:
/// a first pose by orthogonal iteration (Lu, Hager and Mjolsness, IEEE TPAMI 22(6), 2000), then all
/// minima of the error over the plane's turn about the axis that the ambiguity leaves open, each
/// iterated to its end; best first. The minima are found by sampling instead of as a polynomial's
/// roots. Lines of sight are (x, y, 1); points lie on B's z = 0. Empty for fewer than four.
std::vector<PlanarMinimum> RobustPlanarPose(const std::vector<Eigen::Vector2d>& points_B,
                                            const std::vector<Eigen::Vector2d>& sights);

/// Line of sight of a pixel in the linear part of a camera's model (CAHV): focal length and centre
/// as calibrated, the distortion left out (Tsai et al., footnote 1).
Eigen::Vector2d LinearSight(const Camera& camera, const Eigen::Vector2d& pixel);

}  // namespace dockyard
