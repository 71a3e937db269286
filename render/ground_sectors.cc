#include "render/ground_sectors.h"

#include <algorithm>
#include <cmath>

#include "render/ground_mesh.h"

namespace dockyard {
namespace {

constexpr double kSteepest = 0.5;            // level part of a unit ray
constexpr double kHalfTurn_rad = 0.9 * kPi;  // with room for a wide lens, whose rays are few here
constexpr double kFarthest_m = 1.0;          // of the camera from the fan's pole

}  // namespace

SectorRange VisibleSectors(const Pose3& X_FC, const TanRect& r) {
  const SectorRange all{.first = 0, .count = kGroundSectors};
  const double mx = 0.5 * (r.left + r.right), my = 0.5 * (r.top + r.bottom);
  const Eigen::Vector3d middle_F = X_FC.R * Eigen::Vector3d(mx, my, 1.0).normalized();
  if (middle_F.head<2>().norm() < kSteepest || X_FC.p.head<2>().norm() > kFarthest_m) return all;
  const double heading = std::atan2(middle_F.y(), middle_F.x());
  double low = 0.0, high = 0.0;
  for (const double x : {r.left, mx, r.right}) {
    for (const double y : {r.top, my, r.bottom}) {
      const Eigen::Vector3d ray_F = X_FC.R * Eigen::Vector3d(x, y, 1.0).normalized();
      if (ray_F.head<2>().norm() < kSteepest) return all;
      for (const double along_m : {0.2, 0.4, 0.8, 1.6, 6.0, 300.0}) {
        const Eigen::Vector3d p_F = X_FC.p + along_m * ray_F;
        const double azimuth = WrapPi(std::atan2(p_F.y(), p_F.x()) - heading);
        low = std::min(low, azimuth);
        high = std::max(high, azimuth);
      }
    }
  }
  // From outside of it, a convex piece of ground is less than half a turn wide: this view has the
  // pole in it, or nearly so.
  if (high - low > kHalfTurn_rad) return all;
  const double sector = 2.0 * kPi / kGroundSectors;
  const int count = static_cast<int>(std::ceil((high - low) / sector)) + 5;
  if (count >= kGroundSectors) return all;
  const int first = static_cast<int>(std::floor((heading + low) / sector)) - 2;
  return {.first = (first % kGroundSectors + kGroundSectors) % kGroundSectors, .count = count};
}

}  // namespace dockyard
