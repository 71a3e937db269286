// A convex polyhedron: made as the hull of points, and how far points and straight edges reach into
// it. Such as a rock that wheels and cables meet.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// The half-space normal . p <= offset_m; the normal is a unit vector out of the body.
struct HalfSpace {
  Eigen::Vector3d normal{0, 0, 1};
  double offset_m = 0.0;
};

/// All in one frame, the body's. Faces are whole: coplanar triangles share one half-space.
struct ConvexBody {
  std::vector<Eigen::Vector3d> vertices;                // the corners alone
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
  std::vector<std::array<std::uint32_t, 2>> edges;      // between two faces, each once
  std::vector<HalfSpace> faces;                         // the body is what is in all of them
  Eigen::Vector3d centre{0, 0, 0};                      // the vertices' mean, within the body
  double radius_m = 0.0;  // of the sphere about it that holds the body
};

/// The hull of at least four points, not all in one plane; throws std::invalid_argument for others.
/// Points nearer to a face than 1e-9 of the body's size count as on it. Tries all planes through
/// three points, n^4 / 6 operations: for some tens of points.
ConvexBody HullOf(const std::vector<Eigen::Vector3d>& points);

/// The body in frame A that has the pose X_AB.
ConvexBody operator*(const Pose3& X_AB, const ConvexBody& body_B);

/// How far a point is outside of the face that it is furthest outside of; within the body (< 0)
/// that is the distance to the surface, outside of it no more than the distance.
struct FaceDistance {
  double distance_m = 0.0;
  Eigen::Vector3d normal{0, 0, 1};  // of that face, out of the body
};
FaceDistance DistanceTo(const ConvexBody& body, const Eigen::Vector3d& p);

/// Where a ray enters the body from outside, in lengths of its direction; none: it passes, or
/// begins within.
std::optional<double> RayEnters(const ConvexBody& body, const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& direction);

/// The part of a straight edge that is in a body. Shares count from the edge's first end, 0 to 1.
struct PressedEdge {
  double from = 0.0, to = 0.0;  // ends of the part within
  double deepest = 0.0;         // where the surface is furthest away
  // A way by which the edge leaves the body: out of the face that is nearest there, or across the
  // edge where two faces are equally near, for then it crosses a ridge between them.
  double depth_m = 0.0;
  Eigen::Vector3d normal{0, 0, 1};
};

/// The edge from a to b against the body; none: they do not meet. Within, the distance to the
/// surface is a concave function along the edge, so the deepest point is found exactly. far: of the
/// faces, those by which it does not leave; empty: none.
std::optional<PressedEdge> PressEdge(const ConvexBody& body, const Eigen::Vector3d& a,
                                     const Eigen::Vector3d& b, const std::vector<bool>& far = {});

/// Distance to the surface within the body, < 0 outside, at a share of the edge [m].
double DepthAlong(const ConvexBody& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                  double share);

}  // namespace dockyard
