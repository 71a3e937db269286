// How a face's normal changes over the face: rounded rocks have none that holds for a whole can.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/stereo/face_plane.h"

namespace dockyard {

/// The change of the outward normal for each metre along the surface, in the frame that
/// RectifiedPair::X_RC is given in: dn = bend . dp. Symmetric, and 0 along the normal; positive
/// where the surface falls away. By least squares of a quadric through the points within that
/// radius of the plane's point. None with too few points.
std::optional<Eigen::Matrix3d> BendAbout(const RectifiedPair& pair, const Disparities& disparities,
                                         const FacePlane& plane, double radius_m);

}  // namespace dockyard
