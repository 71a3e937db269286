#include "sim/page/simplified.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace dockyard {
namespace {

double Distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - share * along).norm();
}

}  // namespace

std::vector<Eigen::Vector3d> Simplified(const std::vector<Eigen::Vector3d>& points,
                                        double tolerance) {
  if (points.size() < 3) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = Distance(points[i], points[first], points[last]);
      if (distance <= most) continue;
      most = distance;
      farthest = i;
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.push_back({first, farthest});
    open.push_back({farthest, last});
  }
  std::vector<Eigen::Vector3d> simplified;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) simplified.push_back(points[i]);
  }
  return simplified;
}

}  // namespace dockyard
