#include "render/surface_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

constexpr double kCreaseAngle = 40.0 * kPi / 180.0;
constexpr int kTubeSides = 8;

void Check(const RenderMesh& mesh) {
  for (const Eigen::Vector3f& v : mesh.vertices) DOCKYARD_CHECK(v.allFinite());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t i : triangle) DOCKYARD_CHECK(i < mesh.vertices.size());
  }
}

// For each vertex the first one that lies at the same place.
std::vector<std::uint32_t> WeldByPlace(const std::vector<Eigen::Vector3f>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    return std::make_tuple(vertices[i].x(), vertices[i].y(), vertices[i].z(), i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

// Faces round each welded vertex, as one array with starts.
struct FacesAtVertex {
  std::vector<std::uint32_t> start, faces;
};

FacesAtVertex CollectFaces(const RenderMesh& mesh, const std::vector<std::uint32_t>& weld) {
  FacesAtVertex at;
  at.start.assign(mesh.vertices.size() + 1, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t i : triangle) ++at.start[weld[i] + 1];
  }
  std::partial_sum(at.start.begin(), at.start.end(), at.start.begin());
  at.faces.resize(at.start.back());
  std::vector<std::uint32_t> next(at.start.begin(), at.start.end() - 1);
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const std::uint32_t i : mesh.triangles[f]) at.faces[next[weld[i]]++] = f;
  }
  return at;
}

void AddRing(SurfaceMesh& mesh, const Eigen::Vector3d& center, const Eigen::Vector3d& side,
             const Eigen::Vector3d& up, double drawn_m, double coverage) {
  for (int k = 0; k < kTubeSides; ++k) {
    const double angle = 2.0 * kPi * k / kTubeSides;
    const Eigen::Vector3d normal = std::cos(angle) * side + std::sin(angle) * up;
    mesh.vertices.push_back({(center + drawn_m * normal).cast<float>(), normal.cast<float>(),
                             static_cast<float>(coverage)});
  }
}

void StitchRings(SurfaceMesh& mesh, std::size_t rings) {
  for (std::size_t r = 0; r + 1 < rings; ++r) {
    for (int k = 0; k < kTubeSides; ++k) {
      const auto a = static_cast<std::uint32_t>(r * kTubeSides + k);
      const auto b = static_cast<std::uint32_t>(r * kTubeSides + (k + 1) % kTubeSides);
      for (const std::uint32_t i : {a, b, a + kTubeSides, b, b + kTubeSides, a + kTubeSides}) {
        mesh.indices.push_back(i);
      }
    }
  }
}

std::vector<Eigen::Vector3d> WithoutRepeats(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> kept;
  for (const Eigen::Vector3d& p : points) {
    if (kept.empty() || (p - kept.back()).norm() > 1e-6) kept.push_back(p);
  }
  return kept;
}

}  // namespace

SurfaceMesh WithNormals(const RenderMesh& mesh) {
  Check(mesh);
  const auto weld = WeldByPlace(mesh.vertices);
  const FacesAtVertex at = CollectFaces(mesh, weld);
  std::vector<Eigen::Vector3f> area(mesh.triangles.size());  // twice the face's area, along normal
  for (std::size_t f = 0; f < area.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    area[f] = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
  }
  const float smooth = static_cast<float>(std::cos(kCreaseAngle));
  SurfaceMesh out;
  for (std::size_t f = 0; f < area.size(); ++f) {
    if (!(area[f].norm() > 0.0f)) continue;
    const Eigen::Vector3f flat = area[f].normalized();
    for (const std::uint32_t i : mesh.triangles[f]) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (std::uint32_t n = at.start[weld[i]]; n < at.start[weld[i] + 1]; ++n) {
        const Eigen::Vector3f& other = area[at.faces[n]];
        if (other.dot(flat) >= smooth * other.norm()) sum += other;
      }
      out.indices.push_back(static_cast<std::uint32_t>(out.vertices.size()));
      out.vertices.push_back({mesh.vertices[i], sum.normalized(), 1.0f});
    }
  }
  return out;
}

Ball BoundingBall(const RenderMesh& mesh) {
  if (mesh.vertices.empty()) return {};
  Eigen::Vector3d low = mesh.vertices[0].cast<double>(), high = low;
  for (const Eigen::Vector3f& v : mesh.vertices) {
    low = low.cwiseMin(v.cast<double>());
    high = high.cwiseMax(v.cast<double>());
  }
  return {0.5 * (low + high), 0.5 * (high - low).norm()};
}

SurfaceMesh Tube(const std::vector<Eigen::Vector3d>& points, double radius_m,
                 const std::function<double(const Eigen::Vector3d&)>& drawn_radius_m) {
  SurfaceMesh mesh;
  const std::vector<Eigen::Vector3d> line = WithoutRepeats(points);
  if (line.size() < 2 || !(radius_m > 0.0)) return mesh;
  Eigen::Vector3d side = (line[1] - line[0]).unitOrthogonal();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3d along =
        (line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]).normalized();
    // Carried along without twist; a hairpin that turns it into the axis starts afresh.
    const Eigen::Vector3d carried = side - side.dot(along) * along;
    side = carried.norm() > 1e-6 ? carried.normalized() : along.unitOrthogonal();
    const double drawn = std::max(radius_m, drawn_radius_m(line[i]));
    AddRing(mesh, line[i], side, along.cross(side), drawn, radius_m / drawn);
  }
  StitchRings(mesh, line.size());
  return mesh;
}

}  // namespace dockyard
