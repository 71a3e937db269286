// Homography from the board to a plane before the camera. It holds between planes, not on a
// fish-eye image: points are given on the tangent plane of the viewing sphere.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/camera.h"

namespace dockyard {

struct PlanePair {
  Eigen::Vector2d board;  // [m]
  Eigen::Vector2d image;  // on the tangent plane [-]
};

/// The plane that touches the viewing sphere in the middle of the given rays; z of frame T points
/// there. Rays up to 60 deg about it are well represented, wherever in the image they are.
struct TangentPlane {
  Eigen::Matrix3d R_TC = Eigen::Matrix3d::Identity();

  Eigen::Vector2d FromRay(const Eigen::Vector3d& ray_C) const;
  Eigen::Vector3d ToRay(const Eigen::Vector2d& point_T) const;
};
TangentPlane TangentPlaneAt(const std::vector<Eigen::Vector3d>& rays_C);

/// Normalised direct linear transform (Hartley, IEEE TPAMI 19(6), 1997): image ~ H board. Needs
/// four points in general position, none of them at infinity.
std::optional<Eigen::Matrix3d> FitHomography(const std::vector<PlanePair>& pairs);
/// None where the point goes to infinity or behind the camera.
std::optional<Eigen::Vector2d> Map(const Eigen::Matrix3d& H, const Eigen::Vector2d& board);

struct RobustHomography {
  Eigen::Matrix3d H;
  std::vector<bool> inlier;
  double rms = 0.0;  // over the inliers, on the tangent plane
};
/// Leaves out, one by one, the point whose absence helps the rest most, until all lie within the
/// gate. At least min_inliers must stay: four fix a homography, the fifth can vote a false one out
/// (Tsai et al., V-D).
std::optional<RobustHomography> FitHomographyRobust(const std::vector<PlanePair>& pairs,
                                                    double gate, int min_inliers = 5);

}  // namespace dockyard
