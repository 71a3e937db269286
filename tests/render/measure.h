// Numbers measured in rendered images, and their expected values, computed independently.
#pragma once

#include <functional>

#include "render/scene_samples.h"

namespace dockyard {

/// Interpolated radiance at a pixel inside the image.
double RadianceAt(const RadianceImage& image, const Eigen::Vector2d& pixel);

/// Largest difference of two images over the largest value of the first.
double LargestRelativeDifference(const RadianceImage& a, const RadianceImage& b);

/// Centroid of the part darker than white_radiance in the window round a pixel.
Eigen::Vector2d CentroidOfDark(const RadianceImage& image, const Eigen::Vector2d& middle,
                               double half_window_px, double white_radiance);

/// Where a place of a flat print lies in B.
using PlaceOfPrint = std::function<Eigen::Vector3d(const Eigen::Vector2d& p_print)>;
Eigen::Vector3d OnFlatBoard(const Eigen::Vector2d& p_print);

/// Centroid, in the image, of a fiducial's black part: its projected area integrated cell by cell.
Eigen::Vector2d ExactBlackCentroid(const FiducialBoard& board, const Fiducial& fiducial,
                                   const Camera& camera, const Pose3& X_CB,
                                   const PlaceOfPrint& place = OnFlatBoard);

/// Lambert's law as scene.h states it, for an unshaded surface with this world normal.
double UnshadedRadiance(const SunAndSky& light, const Eigen::Vector3d& normal_W, double albedo);

/// A rig whose left camera is at X_WC when the rover stands at the world's origin.
StereoRig RigAt(const Camera& camera, const Pose3& X_WC);

/// Camera at one point, facing another, its x axis level.
Pose3 LookAt(const Eigen::Vector3d& from_W, const Eigen::Vector3d& target_W);

}  // namespace dockyard
