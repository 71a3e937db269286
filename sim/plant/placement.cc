#include "sim/plant/placement.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

constexpr int kTries = 200;

}  // namespace

double RadiusOf(const SceneryItem& solid) {
  return solid.kind == SceneryItem::Kind::kBox ? 0.5 * solid.size_m.head<2>().norm()
                                               : 0.5 * solid.size_m.x();
}

double DistanceTo(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d line = b - a;
  const double share =
      std::clamp((p - a).dot(line) / std::max(1e-12, line.squaredNorm()), 0.0, 1.0);
  return (p - a - share * line).norm();
}

bool PlaceInDisc(RandomStream& random, double radius_m,
                 const std::function<bool(const Eigen::Vector2d&)>& is_free, SceneryItem& solid) {
  for (int tried = 0; tried < kTries; ++tried) {
    const double r_m = radius_m * std::sqrt(random.Uniform());
    const double angle = random.Uniform(-kPi, kPi), turn = random.Uniform(-kPi, kPi);
    const Eigen::Vector2d p(r_m * std::cos(angle), r_m * std::sin(angle));
    if (!is_free(p)) continue;
    solid.X_DO = {p.x(), p.y(), turn};
    return true;
  }
  return false;
}

}  // namespace dockyard
