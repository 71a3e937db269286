#include "sim/rigid/star_body.h"

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

namespace dockyard {
namespace {

using Eigen::Vector3d;

// An icosahedron's corners: two poles and two rings of five, at latitudes of +-atan(1/2).
std::vector<Vector3d> IcosahedronCorners() {
  std::vector<Vector3d> corners{Vector3d::UnitZ()};
  const double z = 1.0 / std::sqrt(5.0), r = 2.0 / std::sqrt(5.0);
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < 5; ++i) {
      const double angle = 2.0 * kPi * (i + 0.5 * ring) / 5.0;
      corners.emplace_back(r * std::cos(angle), r * std::sin(angle), ring == 0 ? z : -z);
    }
  }
  corners.push_back(-Vector3d::UnitZ());
  return corners;
}

// Counter-clockwise from outside.
std::vector<StarBody::Triangle> IcosahedronFaces() {
  std::vector<StarBody::Triangle> faces;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const std::uint32_t next = (i + 1) % 5;
    const std::uint32_t upper = 1 + i, upper_next = 1 + next, lower = 6 + i, lower_next = 6 + next;
    faces.push_back({0, upper, upper_next});
    faces.push_back({upper, lower, upper_next});
    faces.push_back({upper_next, lower, lower_next});
    faces.push_back({11, lower_next, lower});
  }
  return faces;
}

// Of the icosahedron's equal faces that one has a direction in it whose middle is nearest.
std::size_t FaceIn(const StarBody& body, const Vector3d& direction) {
  std::size_t at = 0;
  double best = -1e9;
  for (std::size_t i = 0; i < body.levels.front().size(); ++i) {
    const StarBody::Triangle& t = body.levels.front()[i];
    const double here =
        (body.directions[t[0]] + body.directions[t[1]] + body.directions[t[2]]).dot(direction);
    if (here <= best) continue;
    best = here;
    at = i;
  }
  return at;
}

// The triangle of the finest level in this direction. The planes that part a triangle from its
// three corners are the sides of its middle child.
const StarBody::Triangle& TriangleIn(const StarBody& body, const Vector3d& direction) {
  std::size_t at = FaceIn(body, direction);
  for (std::size_t level = 1; level < body.levels.size(); ++level) {
    const StarBody::Triangle& middle = body.levels[level][4 * at + 3];
    const Vector3d &ab = body.directions[middle[0]], &bc = body.directions[middle[1]],
                   &ca = body.directions[middle[2]];
    const std::size_t child = ab.cross(ca).dot(direction) > 0.0   ? 0
                              : bc.cross(ab).dot(direction) > 0.0 ? 1
                              : ca.cross(bc).dot(direction) > 0.0 ? 2
                                                                  : 3;
    at = 4 * at + child;
  }
  return body.triangles()[at];
}

// Points that lie further below a plane fall away beyond an edge: two sigmas of a roughness of 1
// mm. Assumed, 1-4 mm.
constexpr double kFallsAway_m = 2e-3;
constexpr int kEdgeRounds = 5;

// Least squares of z = a + b x + c y.
Vector3d PlaneOf(const std::vector<Vector3d>& points) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  for (const Vector3d& p : points) {
    const Vector3d row(1.0, p.x(), p.y());
    A += row * row.transpose();
    b += p.z() * row;
  }
  return A.ldlt().solve(b);
}

}  // namespace

StarBody MakeStarBody(const Vector3d& centre, int level,
                      const std::function<double(const Vector3d&)>& radius_m) {
  StarBody body;
  body.centre = centre;
  body.directions = IcosahedronCorners();
  body.levels.push_back(IcosahedronFaces());
  for (int l = 0; l < level; ++l) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), 0);
      if (is_new) {
        at->second = static_cast<std::uint32_t>(body.directions.size());
        body.directions.push_back((body.directions[a] + body.directions[b]).normalized());
      }
      return at->second;
    };
    std::vector<StarBody::Triangle> finer;
    for (const StarBody::Triangle& t : body.levels.back()) {
      const std::uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {ab, t[1], bc}, {ca, bc, t[2]}, {ab, bc, ca}});
    }
    body.levels.push_back(std::move(finer));
  }
  for (const Vector3d& direction : body.directions) {
    const double r = radius_m(direction);
    if (!(r > 0.0)) throw std::invalid_argument("a star body's radius must be positive");
    body.radius_m = std::max(body.radius_m, r);
    body.vertices.push_back(centre + r * direction);
  }
  return body;
}

StarDepth DepthIn(const StarBody& body, const Vector3d& p) {
  const Vector3d out = p - body.centre;
  const double away_m = out.norm();
  if (away_m > body.radius_m) return {body.radius_m - away_m, out / away_m};
  const StarBody::Triangle& t =
      TriangleIn(body, away_m > 0.0 ? Vector3d(out / away_m) : Vector3d::UnitZ());
  const Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]], &c = body.vertices[t[2]];
  const Vector3d normal = (b - a).cross(c - a).normalized();
  return {normal.dot(a - p), normal};
}

std::optional<Vector3d> FirstOnRay(const StarBody& body, const Vector3d& origin,
                                   const Vector3d& direction) {
  // Moeller and Trumbore, J. Graphics Tools 2(1), 1997.
  double nearest = 1e30;
  for (const StarBody::Triangle& t : body.triangles()) {
    const Vector3d& a = body.vertices[t[0]];
    const Vector3d ab = body.vertices[t[1]] - a, ac = body.vertices[t[2]] - a;
    const Vector3d h = direction.cross(ac);
    const double det = ab.dot(h);
    if (det <= 0.0) continue;  // seen from within, or along it
    const Vector3d s = origin - a;
    const double u = s.dot(h) / det;
    const Vector3d q = s.cross(ab);
    const double v = direction.dot(q) / det;
    if (u < 0.0 || v < 0.0 || u + v > 1.0) continue;
    const double at = ac.dot(q) / det;
    if (at > 0.0) nearest = std::min(nearest, at);
  }
  if (nearest == 1e30) return std::nullopt;
  return origin + nearest * direction;
}

std::optional<Vector3d> NormalUnderDisc(const StarBody& body, const Vector3d& centre,
                                        const Vector3d& axis, double radius_m) {
  constexpr int kRings = 4, kOnRing = 12;
  const Vector3d side = axis.unitOrthogonal(), up = axis.cross(side);
  std::vector<Vector3d> points;  // aside, up and along the axis, from the centre
  int inner = 0;
  for (int ring = 1; ring <= kRings; ++ring) {
    const double r = radius_m * std::sqrt(static_cast<double>(ring) / kRings);
    for (int i = 0; i < kOnRing; ++i) {
      const double angle = 2.0 * kPi * (i + 0.5 * (ring % 2)) / kOnRing;
      const Vector3d from =
          centre + r * (std::cos(angle) * side + std::sin(angle) * up) + body.radius_m * axis;
      const auto hit = FirstOnRay(body, from, -axis);
      if (!hit) continue;
      inner += ring == 1;
      const Vector3d at = *hit - centre;
      points.emplace_back(at.dot(side), at.dot(up), at.dot(axis));
    }
  }
  // From the inner ring's plane outwards: one through all would already lean over an edge.
  if (inner < kOnRing) return std::nullopt;
  Vector3d plane = PlaneOf({points.begin(), points.begin() + kOnRing});
  for (int round = 0; round < kEdgeRounds; ++round) {
    std::vector<Vector3d> on_face;
    for (const Vector3d& p : points) {
      if (plane.dot(Vector3d(1.0, p.x(), p.y())) - p.z() < kFallsAway_m) on_face.push_back(p);
    }
    if (on_face.size() < kOnRing) return std::nullopt;
    plane = PlaneOf(on_face);
  }
  return (axis - plane[1] * side - plane[2] * up).normalized();
}

}  // namespace dockyard
