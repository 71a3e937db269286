// Maps of heights of a ground that is known in closed form, with noise as stereo has it.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "controller/stereo/elevation.h"
#include "sim/base/random.h"

namespace dockyard {

struct HalfBall {
  Eigen::Vector2d p{0, 0};
  double radius_m = 0.0, height_m = 0.0;  // an upright half of an ellipsoid
};

struct HeightScene {
  std::vector<HalfBall> stones;
  double slope_x = 0.0;

  double Height(const Eigen::Vector2d& p) const {
    double height = 0.0;
    for (const HalfBall& stone : stones) {
      const double rest = 1.0 - (p - stone.p).squaredNorm() / (stone.radius_m * stone.radius_m);
      if (rest > 0.0) height = std::max(height, stone.height_m * std::sqrt(rest));
    }
    return height + slope_x * p.x();
  }

  /// As seen from a rover at X_WE, whose map reaches 1.2 m ahead.
  ElevationMap Map(const Pose2& X_WE, double sigma_m, RandomStream& random) const {
    ElevationMap map;
    map.cell_m = 5e-3;
    map.nx = 240;
    map.ny = 200;
    map.x0_m = 0.0025;
    map.y0_m = -0.4975;
    for (int iy = 0; iy < map.ny; ++iy) {
      for (int ix = 0; ix < map.nx; ++ix) {
        const Eigen::Vector2d p_E(map.x0_m + ix * map.cell_m, map.y0_m + iy * map.cell_m);
        map.height_m.push_back(static_cast<float>(Height(X_WE * p_E) + sigma_m * random.Normal()));
        map.sigma_m.push_back(static_cast<float>(sigma_m));
        map.points.push_back(1);
      }
    }
    return map;
  }
};

/// Takes the map's cells away that lie behind the stone, as its shadow does in a picture.
inline void Hide(ElevationMap& map, const Eigen::Vector2d& p_E, double half_m) {
  for (int iy = 0; iy < map.ny; ++iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      const Eigen::Vector2d at(map.x0_m + ix * map.cell_m, map.y0_m + iy * map.cell_m);
      if ((at - p_E).cwiseAbs().maxCoeff() > half_m) continue;
      const auto cell = static_cast<std::size_t>(iy * map.nx + ix);
      map.points[cell] = 0;
      map.height_m[cell] = map.sigma_m[cell] = std::numeric_limits<float>::quiet_NaN();
    }
  }
}

}  // namespace dockyard
