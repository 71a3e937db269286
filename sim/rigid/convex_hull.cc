#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "sim/rigid/convex_body.h"

namespace dockyard {
namespace {

constexpr double kOnFace = 1e-9;     // of the body's size
constexpr double kLeastArea = 1e-6;  // of its square: what three points must span to give a plane

using Corners = std::vector<std::uint32_t>;

// Each point once.
std::vector<Eigen::Vector3d> Apart(const std::vector<Eigen::Vector3d>& points, double least_m) {
  std::vector<Eigen::Vector3d> apart;
  for (const Eigen::Vector3d& p : points) {
    const bool known = std::any_of(apart.begin(), apart.end(), [&](const Eigen::Vector3d& q) {
      return (p - q).norm() < least_m;
    });
    if (!known) apart.push_back(p);
  }
  return apart;
}

// Those of the points that are corners of their outline, seen along the normal; counter-clockwise
// from outside (Andrew's monotone chain).
Corners Outline(const std::vector<Eigen::Vector3d>& points, const Corners& on,
                const Eigen::Vector3d& normal, double least_area) {
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d u = normal.cross(Eigen::Vector3d::Unit(least)).normalized();
  const Eigen::Vector3d v = normal.cross(u);
  std::vector<std::pair<Eigen::Vector2d, std::uint32_t>> flat;
  for (const std::uint32_t i : on) {
    flat.push_back({Eigen::Vector2d(u.dot(points[i]), v.dot(points[i])), i});
  }
  std::sort(flat.begin(), flat.end(), [](const auto& a, const auto& b) {
    return a.first.x() != b.first.x() ? a.first.x() < b.first.x() : a.first.y() < b.first.y();
  });
  const auto Turns = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Eigen::Vector2d ab = flat[b].first - flat[a].first, ac = flat[c].first - flat[a].first;
    return ab.x() * ac.y() - ab.y() * ac.x() > least_area;
  };
  std::vector<std::size_t> chain;
  const auto Walk = [&](std::size_t first, std::size_t i) {
    while (chain.size() >= first + 2 && !Turns(chain[chain.size() - 2], chain.back(), i)) {
      chain.pop_back();
    }
    chain.push_back(i);
  };
  for (std::size_t i = 0; i < flat.size(); ++i) Walk(0, i);
  const std::size_t half = chain.size() - 1;
  for (std::size_t i = flat.size() - 1; i-- > 0;) Walk(half, i);
  chain.pop_back();
  Corners outline;
  for (const std::size_t i : chain) outline.push_back(flat[i].second);
  return outline;
}

Corners PointsOn(const std::vector<Eigen::Vector3d>& points, const HalfSpace& plane, double on_m) {
  Corners on;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (plane.normal.dot(points[i]) - plane.offset_m > -on_m) {
      on.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return on;
}

// +1 if no point is above the plane, -1 if none is below it, else 0.
double OuterSide(const std::vector<Eigen::Vector3d>& points, const HalfSpace& plane, double on_m) {
  bool above = false, below = false;
  for (const Eigen::Vector3d& p : points) {
    const double height_m = plane.normal.dot(p) - plane.offset_m;
    above |= height_m > on_m;
    below |= height_m < -on_m;
    if (above && below) return 0.0;
  }
  return above ? -1.0 : 1.0;
}

// Every face of the hull once, by its corners.
std::vector<Corners> FindFaces(const std::vector<Eigen::Vector3d>& points, double size_m,
                               std::vector<HalfSpace>& planes) {
  std::vector<Corners> faces, known;
  const double on_m = kOnFace * size_m;
  const auto Try = [&](std::size_t i, std::size_t j, std::size_t k) {
    Eigen::Vector3d across = (points[j] - points[i]).cross(points[k] - points[i]);
    if (across.norm() < kLeastArea * size_m * size_m) return;
    across.normalize();
    HalfSpace plane{across, across.dot(points[i])};
    const double side = OuterSide(points, plane, on_m);
    if (side == 0.0) return;
    for (const Corners& on : known) {
      const auto Has = [&](std::size_t p) {
        return std::binary_search(on.begin(), on.end(), static_cast<std::uint32_t>(p));
      };
      if (Has(i) && Has(j) && Has(k)) return;
    }
    plane = {side * plane.normal, side * plane.offset_m};
    Corners on = PointsOn(points, plane, on_m);
    Corners outline = Outline(points, on, plane.normal, on_m * size_m);
    if (outline.size() < 3) return;
    known.push_back(std::move(on));
    faces.push_back(std::move(outline));
    planes.push_back(plane);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) Try(i, j, k);
    }
  }
  return faces;
}

}  // namespace

ConvexBody HullOf(const std::vector<Eigen::Vector3d>& all) {
  if (all.size() < 4) throw std::invalid_argument("a hull needs four points");
  Eigen::Vector3d low = all[0], high = all[0];
  for (const Eigen::Vector3d& p : all) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size_m = (high - low).norm();
  const std::vector<Eigen::Vector3d> points = Apart(all, kOnFace * size_m);
  ConvexBody body;
  const std::vector<Corners> outlines = FindFaces(points, size_m, body.faces);
  if (outlines.size() < 4) throw std::invalid_argument("a hull needs points out of one plane");
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(points.size(), kNone);
  for (const Corners& outline : outlines) {
    for (const std::uint32_t i : outline) number[i] = 0;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == kNone) continue;
    number[i] = static_cast<std::uint32_t>(body.vertices.size());
    body.vertices.push_back(points[i]);
    body.centre += points[i];
  }
  body.centre /= static_cast<double>(body.vertices.size());
  for (const Eigen::Vector3d& p : body.vertices) {
    body.radius_m = std::max(body.radius_m, (p - body.centre).norm());
  }
  for (const Corners& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const std::uint32_t a = number[outline[i]], b = number[outline[(i + 1) % outline.size()]];
      if (a < b) body.edges.push_back({a, b});  // the face beyond it has it the other way round
      if (i >= 2) body.triangles.push_back({number[outline[0]], number[outline[i - 1]], a});
    }
  }
  return body;
}

}  // namespace dockyard
