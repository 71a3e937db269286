// The plane of a face about a pixel, from disparities.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/stereo/match.h"

namespace dockyard {

struct FacePlaneSettings {
  double radius_m = 0.035;  // of the part of the face that counts; a can's is 33 mm
  // At least so large in the picture, whatever that is on the face. Assumed, 8-14 px.
  int least_px = 10;
  int least_points = 40;
  double most_off_px = 1.0;  // points further off the plane do not count; assumed, 0.5-2
};

/// In the frame that RectifiedPair::X_RC is given in.
struct FacePlane {
  Eigen::Vector3d p{0, 0, 0};       // on the plane, under the pixel
  Eigen::Vector3d normal{0, 0, 1};  // towards the camera
  int points = 0;
  double off_px = 0.0;            // root mean square of the points' disparities about the plane's
  double normal_sigma_rad = 0.0;  // along the worse direction
  Eigen::Matrix3d bend_per_m = Eigen::Matrix3d::Zero();  // BendAbout it; 0: taken to be flat
};

/// The disparity of a plane is linear in the pixel's place, and its error is alike everywhere: so
/// the plane is fitted there, robustly. None with too few points about the pixel.
std::optional<FacePlane> PlaneUnder(const RectifiedPair& pair, const Disparities& disparities,
                                    const Eigen::Vector2d& pixel,
                                    const FacePlaneSettings& settings);

/// The point under a pixel, by the median of its neighbours' disparities within beside_px; in C.
std::optional<Eigen::Vector3d> PointUnder(const RectifiedPair& pair, const Disparities& disparities,
                                          const Eigen::Vector2d& pixel, int beside_px = 2);

}  // namespace dockyard
