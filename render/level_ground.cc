#include "render/level_ground.h"

#include <cmath>

#include "render/scene_painter.h"

namespace dockyard {

void AddLevelGround(const GroundView& ground, const Pose3& X_WV, FlatView& view) {
  const Eigen::Vector3d up_V = X_WV.R.transpose() * ground.X_WG.R.col(2);
  const double below = (Inverse(ground.X_WG) * X_WV.p).z() - *ground.heights_m;  // the camera's
  if (std::abs(below) < 1e-6) return;
  const Eigen::Vector3d plane = -up_V / below;
  const double step_x = (view.rect.right - view.rect.left) / view.width;
  const double step_y = (view.rect.bottom - view.rect.top) / view.height;
  const auto per_x = static_cast<float>(plane.x() * step_x);
  const auto nearest = static_cast<float>(1.0 / kNear_m);
  for (int y = 0; y < view.height; ++y) {
    const double at_y = view.rect.top + (y + 0.5) * step_y;
    const auto first = static_cast<float>(plane.x() * (view.rect.left + 0.5 * step_x) +
                                          plane.y() * at_y + plane.z());
    Seen* row = &view.seen[static_cast<std::size_t>(y) * view.width];
    for (int x = 0; x < view.width; ++x) {
      const float code = first + static_cast<float>(x) * per_x;
      if (code > InverseDepth(row[x].code) && code > 0.0f && code < nearest)
        row[x] = {.object = 0, .code = code};
    }
  }
}

}  // namespace dockyard
