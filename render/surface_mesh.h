// Geometry as the GPU wants it: vertices with normals and coverage. Plain arithmetic, no GL.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "render/scene.h"

namespace dockyard {

/// Coverage below 1 stands for a body thinner than it is drawn.
struct SurfaceVertex {
  Eigen::Vector3f position, normal;
  float coverage = 1.0f;
};

struct SurfaceMesh {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
};

/// Normals by crease angle: faces that meet at less than 40 deg share a normal (assumed, 30-60 deg
/// is what modelling tools default to), sharper edges stay sharp. Degenerate triangles are dropped.
/// The readers of meshes refuse vertices that are not finite, and triangles of others.
SurfaceMesh WithNormals(const RenderMesh& mesh);

/// Centre and radius of a ball round all vertices, in the mesh's frame; radius 0 when empty.
struct Ball {
  Eigen::Vector3d center{0, 0, 0};
  double radius = 0.0;
};
Ball BoundingBall(const RenderMesh& mesh);

/// A closed round tube along a polyline, as thick at each point as drawn_radius_m says there; where
/// that exceeds the true radius, coverage falls in proportion. Frame: that of the points.
SurfaceMesh Tube(const std::vector<Eigen::Vector3d>& points, double radius_m,
                 const std::function<double(const Eigen::Vector3d&)>& drawn_radius_m);

}  // namespace dockyard
