// Internal to the vision room. The dockyard pipeline's estimator on pixels of any body's points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/vision/points/point_pose.h"

namespace dockyard {

/// The pipeline `dockyard` of PoseFromPoints.
Result<PointPose, PoseFailure> SearchPose(const std::vector<PointPixel>& points,
                                          const std::vector<CameraView>& views,
                                          const PointOptions& options);

/// Normal of the plane that the points lie in, and their centre; none when they fill space.
std::optional<Eigen::Vector3d> PlaneNormal(const std::vector<PointPixel>& points,
                                           Eigen::Vector3d* centre);

/// "stereo", "left" or "right": the images of the chosen pixels.
std::string Method(const std::vector<PointPixel>& points, const std::vector<bool>& chosen);

}  // namespace dockyard
