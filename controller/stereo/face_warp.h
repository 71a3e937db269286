// A patch of a face drawn as from another place: by its plane, and what a bend adds to that.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

#include "controller/geometry/pose.h"
#include "controller/stereo/kept_face.h"

namespace dockyard {

struct WarpedGreys {
  cv::Mat greys, on_face;  // CV_8U
};

/// The older image as from the new place, in a square about a pixel there; none beyond its borders.
/// @param X_NC  the older camera in the new one
/// @param half  of the square's side, px
std::optional<WarpedGreys> WarpedPatch(const FacePatch& patch, const Pose3& X_NC,
                                       const Eigen::Vector2i& middle, int half);

/// How far in the new image a bend of one sigma moves what lies half a side from the patch's
/// middle, px: along the parallax of what is off the plane.
Eigen::Vector2d BendAtEdge(const FacePatch& patch, const Pose3& X_NC, int half);

}  // namespace dockyard
