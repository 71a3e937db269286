#include "sim/vehicles/surface_points.h"

#include <algorithm>
#include <cmath>

namespace dockyard {

using Eigen::Vector3d;

std::vector<Vector3d> SurfacePoints(const ConvexBody& body, double apart_m) {
  std::vector<Vector3d> points = body.vertices;
  for (const auto& t : body.triangles) {
    const Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]], &c = body.vertices[t[2]];
    const double longest_m = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int pieces = static_cast<int>(std::ceil(longest_m / apart_m));
    for (int i = 0; i <= pieces; ++i) {
      for (int k = 0; i + k <= pieces; ++k) {
        if (i == pieces || k == pieces || i + k == 0) continue;  // corners
        const double at_b = static_cast<double>(i) / pieces, at_c = static_cast<double>(k) / pieces;
        const Vector3d p = a + at_b * (b - a) + at_c * (c - a);
        const auto IsSame = [&](const Vector3d& q) { return (p - q).norm() < 1e-6 * apart_m; };
        if (std::none_of(points.begin(), points.end(), IsSame)) points.push_back(p);
      }
    }
  }
  return points;
}

std::vector<Vector3d> WheelPoints(const WheelModel& wheel, double apart_m) {
  const double radius_m = RollingRadius(wheel);
  const int count = static_cast<int>(std::ceil(2.0 * kPi * radius_m / apart_m));
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * i / count;
    for (const double side : {-0.5, 0.0, 0.5}) {
      points.emplace_back(radius_m * std::cos(angle), side * wheel.width_m,
                          radius_m * std::sin(angle));
    }
  }
  return points;
}

}  // namespace dockyard
