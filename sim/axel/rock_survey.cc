#include "sim/axel/rock_survey.h"

#include <algorithm>

#include "sim/base/random.h"

namespace dockyard::axel {

RockMap RockMapOf(const RockMapKeys& keys, const RockBed& bed, const HeightGrid& ground,
                  const Pose2& X_GD, const Seed& run_seed) {
  if (!keys.rocks.empty()) return {keys.rocks, keys.sigma_m};
  if (!keys.made) return {};
  RockMap map{.rocks = {}, .sigma_m = keys.sigma_m};
  RandomStream errors(StreamKey(run_seed, "rock_map"));
  for (const ConvexBody& rock : bed.rocks) {
    // Drawn for the low ones, too, so that a rock's error does not hang on the least height.
    const double error_x_m = keys.sigma_m * errors.Normal();
    const double error_y_m = keys.sigma_m * errors.Normal();
    Eigen::Vector2d low = rock.vertices.front().head<2>(), high = low;
    double top_m = rock.vertices.front().z();
    for (const Eigen::Vector3d& p : rock.vertices) {
      low = low.cwiseMin(p.head<2>());
      high = high.cwiseMax(p.head<2>());
      top_m = std::max(top_m, p.z());
    }
    const Eigen::Vector2d middle_G = 0.5 * (low + high);
    const double height_m = top_m - ground.Height(middle_G.x(), middle_G.y());
    if (height_m < keys.least_height_m) continue;
    double radius_m = 0.0;
    for (const Eigen::Vector3d& p : rock.vertices) {
      radius_m = std::max(radius_m, (p.head<2>() - middle_G).norm());
    }
    const Eigen::Vector2d middle_D = Inverse(X_GD) * middle_G;
    map.rocks.push_back({middle_D.x() + error_x_m, middle_D.y() + error_y_m, radius_m, height_m});
  }
  return map;
}

}  // namespace dockyard::axel
