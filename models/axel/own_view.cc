#include "models/axel/own_view.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace dockyard::axel {
namespace {

constexpr int kColumns = 8, kRows = 6;  // of rays: one for an eighth of the image's width
// The renderer draws nothing nearer (render/flat_view.h), such as a lens's own rim.
constexpr double kNear_m = 0.02;
// Of an image; assumed, 0.4-0.8. Axel's cameras have none. At the other places in the limits of
// axel.yaml the wheels fill 0.31 at most.
constexpr double kMostShare = 0.5;

struct Triangle {
  Eigen::Vector3d a, ab, ac;  // corner and edges, in R
};

void AddTriangles(const LinkModel& link, const Eigen::Vector3d& p_RLink,
                  std::vector<Triangle>& triangles) {
  for (const Visual& visual : link.visuals) {
    const auto at = [&](std::uint32_t i) -> Eigen::Vector3d {
      return p_RLink + visual.X_LV * visual.mesh->vertices[i];
    };
    for (const auto& t : visual.mesh->triangles) {
      const Eigen::Vector3d a = at(t[0]);
      triangles.push_back({a, at(t[1]) - a, at(t[2]) - a});
    }
  }
}

/// Moeller and Trumbore, Fast, Minimum Storage Ray-Triangle Intersection (1997): from either side.
bool Meets(const Triangle& triangle, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  const Eigen::Vector3d p = along.cross(triangle.ac);
  const double determinant = triangle.ab.dot(p);
  if (std::abs(determinant) < 1e-15) return false;
  const Eigen::Vector3d t = from - triangle.a;
  const double u = t.dot(p) / determinant;
  if (u < 0.0 || u > 1.0) return false;
  const Eigen::Vector3d q = t.cross(triangle.ab);
  const double v = along.dot(q) / determinant;
  return v >= 0.0 && u + v <= 1.0 && triangle.ac.dot(q) / determinant > kNear_m;
}

double ShareOf(const std::vector<Triangle>& triangles, const Camera& camera, const Pose3& X_RC) {
  int met = 0;
  for (int i = 0; i < kColumns * kRows; ++i) {
    const double u = (i % kColumns + 0.5) / kColumns, v = (i / kColumns + 0.5) / kRows;
    const LensRay ray = camera.Ray({u * camera.width - 0.5, v * camera.height - 0.5});
    const Eigen::Vector3d from = X_RC * ray.origin, along = X_RC.R * ray.direction.normalized();
    for (const Triangle& triangle : triangles) {
      if (!Meets(triangle, from, along)) continue;
      ++met;
      break;
    }
  }
  return static_cast<double>(met) / (kColumns * kRows);
}

std::vector<Triangle> OwnBody(const RoverModel& rover) {
  std::vector<Triangle> triangles;
  AddTriangles(rover.body, Eigen::Vector3d::Zero(), triangles);
  AddTriangles(rover.left_wheel, rover.p_R_left_wheel, triangles);
  AddTriangles(rover.right_wheel, rover.p_R_right_wheel, triangles);
  return triangles;
}

}  // namespace

double ShareOfOwnBody(const RoverModel& rover, const Camera& camera, const Pose3& X_RC) {
  return ShareOf(OwnBody(rover), camera, X_RC);
}

std::string BlindedBy(const RoverModel& rover) {
  const std::vector<Triangle> triangles = OwnBody(rover);
  const StereoRig& rig = rover.stereo.nominal;
  const double left = ShareOf(triangles, rig.left, rig.X_RL),
               right = ShareOf(triangles, rig.right, rig.X_RQ);
  if (std::max(left, right) <= kMostShare) return {};
  return std::to_string(static_cast<int>(std::round(100.0 * std::max(left, right)))) +
         " % of the " + (left >= right ? "left" : "right") + " image";
}

}  // namespace dockyard::axel
