#include <cmath>
#include <utility>

#include "models/read/mesh_loader.h"

namespace dockyard {

TriangleMesh Scaled(const TriangleMesh& mesh, const Eigen::Vector3d& scale) {
  TriangleMesh scaled = mesh;
  for (Eigen::Vector3d& v : scaled.vertices) v = v.cwiseProduct(scale);
  if (scale.prod() < 0.0) {
    for (auto& triangle : scaled.triangles) std::swap(triangle[1], triangle[2]);
  }
  return scaled;
}

TriangleMesh BoxMesh(const Eigen::Vector3d& size_m) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                               corner & 4 ? 0.5 : -0.5);
    mesh.vertices.push_back(size_m.cwiseProduct(sign));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh CylinderMesh(double radius_m, double length_m, int sides) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, -0.5 * length_m}, {0, 0, 0.5 * length_m}};
  const auto n = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2.0 * kPi * i / sides;
    const double x = radius_m * std::cos(angle), y = radius_m * std::sin(angle);
    mesh.vertices.emplace_back(x, y, -0.5 * length_m);
    mesh.vertices.emplace_back(x, y, 0.5 * length_m);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t low = 2 + 2 * i, next = 2 + 2 * ((i + 1) % n);
    mesh.triangles.push_back({0, next, low});
    mesh.triangles.push_back({1, low + 1, next + 1});
    mesh.triangles.push_back({low, next, next + 1});
    mesh.triangles.push_back({low, next + 1, low + 1});
  }
  return mesh;
}

TriangleMesh SphereMesh(double radius_m, int rings) {
  TriangleMesh mesh;
  const auto sides = static_cast<std::uint32_t>(2 * rings);
  mesh.vertices = {{0, 0, radius_m}, {0, 0, -radius_m}};
  for (int ring = 1; ring < rings; ++ring) {
    const double theta = kPi * ring / rings;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double phi = 2.0 * kPi * i / sides;
      mesh.vertices.emplace_back(radius_m * std::sin(theta) * std::cos(phi),
                                 radius_m * std::sin(theta) * std::sin(phi),
                                 radius_m * std::cos(theta));
    }
  }
  const auto at = [&](int ring, std::uint32_t i) {
    return 2 + static_cast<std::uint32_t>(ring - 1) * sides + i % sides;
  };
  for (std::uint32_t i = 0; i < sides; ++i) {
    mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
    mesh.triangles.push_back({1, at(rings - 1, i + 1), at(rings - 1, i)});
    for (int ring = 1; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  }
  return mesh;
}

}  // namespace dockyard
