#include "models/read/convex_pieces.h"

#include <bullet/HACD/hacdHACD.h>

#include <algorithm>
#include <array>
#include <map>

#include "controller/base/check.h"
#include "controller/geometry/decompositions.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostFaces = 1000, kMostCorners = 20000;  // asked by IsConvex
constexpr std::size_t kMostCornersOfPiece = 100;
// How deep a hollow of a piece may be by HACD's measure, in which the mesh has the size 1000: the
// first of these that gives solid pieces. Less leaves gaps between the pieces of a thin ring.
constexpr double kConcavities[] = {20.0, 40.0, 80.0};
// Points in a layer thinner than this share of their diagonal are flat.
constexpr double kFlat = 1e-4;
// Of its cost: 0.1 prefers compact pieces a little, as its authors do.
constexpr double kCompactness = 0.1;

// Six times the volume; < 0: the triangles are clockwise from outside.
double SignedVolume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
  }
  return sum;
}

double Diagonal(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.vertices) box.extend(p);
  return box.diagonal().norm();
}

std::size_t StepFor(std::size_t count, std::size_t most) { return 1 + (count - 1) / most; }

// The same mesh with each place once: files repeat it for every triangle, and hollows are sought
// across shared edges.
TriangleMesh Joined(const TriangleMesh& mesh) {
  const double cell_m = 1e-6 * Diagonal(mesh);
  TriangleMesh joined;
  std::map<std::array<long long, 3>, std::uint32_t> places;
  std::vector<std::uint32_t> number;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    std::array<long long, 3> key{};
    for (int k = 0; k < 3; ++k) key[static_cast<std::size_t>(k)] = std::llround(p[k] / cell_m);
    const auto [at, fresh] =
        places.emplace(key, static_cast<std::uint32_t>(joined.vertices.size()));
    if (fresh) joined.vertices.push_back(p);
    number.push_back(at->second);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<std::uint32_t, 3> ends{number[a], number[b], number[c]};
    if (ends[0] != ends[1] && ends[1] != ends[2] && ends[2] != ends[0]) {
      joined.triangles.push_back(ends);
    }
  }
  return joined;
}

using Points = std::vector<Eigen::Vector3d>;

std::vector<Points> Part(const TriangleMesh& mesh, double concavity) {
  const bool turned = SignedVolume(mesh) < 0.0;
  std::vector<HACD::Vec3<HACD::Real>> points;
  for (const Eigen::Vector3d& p : mesh.vertices) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<HACD::Vec3<long>> triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    triangles.emplace_back(a, turned ? c : b, turned ? b : c);
  }
  HACD::HACD hacd;
  hacd.SetPoints(points.data());
  hacd.SetNPoints(points.size());
  hacd.SetTriangles(triangles.data());
  hacd.SetNTriangles(triangles.size());
  hacd.SetNClusters(1);
  hacd.SetConcavity(concavity);
  hacd.SetCompacityWeight(kCompactness);
  hacd.SetVolumeWeight(0.0);
  hacd.SetNVerticesPerCH(kMostCornersOfPiece);
  hacd.SetAddExtraDistPoints(true);
  hacd.SetAddNeighboursDistPoints(true);
  hacd.SetAddFacesPoints(true);
  hacd.Compute(true, false);
  hacd.DenormalizeData();
  std::vector<Points> pieces;
  for (std::size_t i = 0; i < hacd.GetNClusters(); ++i) {
    std::vector<HACD::Vec3<HACD::Real>> corners(hacd.GetNPointsCH(i));
    std::vector<HACD::Vec3<long>> faces(hacd.GetNTrianglesCH(i));
    hacd.GetCH(i, corners.data(), faces.data());
    Points& piece = pieces.emplace_back();
    for (auto& corner : corners) piece.emplace_back(corner.X(), corner.Y(), corner.Z());
  }
  return pieces;
}

}  // namespace

bool IsConvex(const TriangleMesh& mesh) {
  DOCKYARD_CHECK(!mesh.triangles.empty());
  const double side = SignedVolume(mesh) < 0.0 ? -1.0 : 1.0;
  const double most_m = kFilledHollow * Diagonal(mesh);
  const std::size_t faces = StepFor(mesh.triangles.size(), kMostFaces);
  const std::size_t corners = StepFor(mesh.vertices.size(), kMostCorners);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += faces) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Eigen::Vector3d& p = mesh.vertices[a];
    const Eigen::Vector3d normal = side * (mesh.vertices[b] - p).cross(mesh.vertices[c] - p);
    const double size = normal.norm();
    for (std::size_t k = 0; k < mesh.vertices.size(); k += corners) {
      if (normal.dot(mesh.vertices[k] - p) > most_m * size) return false;
    }
  }
  return true;
}

bool IsFlat(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() < 4) return true;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : points) {
    middle += p / static_cast<double>(points.size());
    box.extend(p);
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) spread += (p - middle) * (p - middle).transpose();
  const Eigen::Vector3d across = EigenOfSymmetric(spread).vectors.col(0);
  double low = 0.0, high = 0.0;
  for (const Eigen::Vector3d& p : points) {
    low = std::min(low, across.dot(p - middle));
    high = std::max(high, across.dot(p - middle));
  }
  return high - low <= kFlat * box.diagonal().norm();
}

std::vector<std::vector<Eigen::Vector3d>> ConvexPieces(const TriangleMesh& mesh) {
  DOCKYARD_CHECK(!mesh.triangles.empty() && mesh.triangles.size() <= kMostPartedTriangles);
  const TriangleMesh joined = Joined(mesh);
  if (joined.triangles.empty()) return {mesh.vertices};
  for (const double concavity : kConcavities) {
    std::vector<Points> pieces = Part(joined, concavity);
    if (!pieces.empty() && std::none_of(pieces.begin(), pieces.end(), IsFlat)) return pieces;
  }
  return {joined.vertices};
}

}  // namespace dockyard
