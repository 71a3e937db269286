// A body whose surface every ray from its centre meets once, as a mesh of triangles: a boulder with
// dents. Where a point lies against it is found by the direction in which it lies.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// Triangles are those of an icosahedron, each cut into four again and again; of every level, so
/// that child k of triangle t is 4 t + k on the next one.
struct StarBody {
  using Triangle = std::array<std::uint32_t, 3>;

  Eigen::Vector3d centre{0, 0, 0};
  double radius_m = 0.0;                    // of the sphere about the centre that holds the body
  std::vector<Eigen::Vector3d> directions;  // unit, from the centre
  std::vector<Eigen::Vector3d> vertices;    // on them
  std::vector<std::vector<Triangle>> levels;

  const std::vector<Triangle>& triangles() const { return levels.back(); }
};

/// The surface at radius(direction) from the centre, in 20 x 4^level triangles. Throws
/// std::invalid_argument for a radius that is not positive.
StarBody MakeStarBody(const Eigen::Vector3d& centre, int level,
                      const std::function<double(const Eigen::Vector3d&)>& radius_m);

/// How deep a point is below the surface, < 0 outside: its distance from the plane of the triangle
/// that lies in its direction. Exact near a face, and what a contact needs.
struct StarDepth {
  double depth_m = 0.0;
  Eigen::Vector3d normal{0, 0, 1};  // out of the body
};
StarDepth DepthIn(const StarBody& body, const Eigen::Vector3d& p);

/// The first point of the surface that a ray meets from outside; none: it passes. Looks at every
/// triangle.
std::optional<Eigen::Vector3d> FirstOnRay(const StarBody& body, const Eigen::Vector3d& origin,
                                          const Eigen::Vector3d& direction);

/// The surface's normal over a disc: of the plane by least squares through points on it, brought
/// onto the surface along -axis, without those that fall away beyond an edge. None where the
/// surface is not there under the disc's inner half.
std::optional<Eigen::Vector3d> NormalUnderDisc(const StarBody& body, const Eigen::Vector3d& centre,
                                               const Eigen::Vector3d& axis, double radius_m);

}  // namespace dockyard
