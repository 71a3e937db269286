#include "render/ground_horizon.h"

#include <algorithm>

#include "render/ground_mesh.h"

namespace dockyard {

GroundHorizon::GroundHorizon(const Scene& scene, double highest_m) : ground_(scene.ground) {
  const Eigen::Vector3d sun_G = ground_.X_WG.R.transpose() * scene.light.to_sun_W;
  const double level = sun_G.head<2>().norm();
  if (!HasGround(ground_) || level < 1e-6) return;  // a sun at the zenith: nothing is between
  level_ = (sun_G.head<2>() / level).cast<float>();
  slope_ = static_cast<float>(sun_G.z() / level);
  // Over a level metre the disc's radius takes up 1 / cos^2 of the elevation times as much height:
  // the way there is longer, and the disc stands askew.
  const double radius = std::max(0.5 * scene.light.sun_angular_diameter_rad, 1e-4);
  sun_rise_ = static_cast<float>(radius / std::max(level * level, 1e-4));
  highest_m_ = static_cast<float>(highest_m);
}

float GroundHorizon::Share(const Eigen::Vector3f& p_G) const {
  constexpr int kMostSteps = 96;  // cells; longer shadows end there
  const auto cell = static_cast<float>(ground_.cell_m);
  float share = 1.0f;
  for (int i = 1; i <= kMostSteps; ++i) {
    const float along = cell * static_cast<float>(i);
    const float ray_m = p_G.z() + along * slope_;
    if (ray_m > highest_m_ + 2.0f * sun_rise_ * along) break;
    const float u = (p_G.x() + along * level_.x() - static_cast<float>(ground_.x0_m)) / cell;
    const float v = (p_G.y() + along * level_.y() - static_cast<float>(ground_.y0_m)) / cell;
    if (!(u >= 0.0f && v >= 0.0f && u < static_cast<float>(ground_.nx - 1) &&
          v < static_cast<float>(ground_.ny - 1))) {
      break;
    }
    const int ix = static_cast<int>(u), iy = static_cast<int>(v);
    const float fx = u - static_cast<float>(ix), fy = v - static_cast<float>(iy);
    const double* h = ground_.heights_m + static_cast<std::size_t>(iy) * ground_.nx + ix;
    const auto height =
        static_cast<float>((1 - fy) * ((1 - fx) * h[0] + fx * h[1]) +
                           fy * ((1 - fx) * h[ground_.nx] + fx * h[ground_.nx + 1]));
    // The horizon there against the sun's disc, which counts as a uniform strip.
    const float over = (height - ray_m) / (sun_rise_ * along);
    share = std::min(share, std::clamp(0.5f - 0.5f * over, 0.0f, 1.0f));
  }
  return share;
}

}  // namespace dockyard
