#include "render/kept_lenses.h"

#include <algorithm>

namespace dockyard {
namespace {

void FillGrid(const Scene& scene, const Pose3& X_WC, KeptLens& lens) {
  const Camera& camera = lens.scale.camera();
  const RayEnds ends(scene, X_WC);
  const std::size_t corners = static_cast<std::size_t>(camera.width + 1) * (camera.height + 1);
  lens.grid = {.width = camera.width, .height = camera.height, .x = {}, .y = {}};
  lens.grid.x.reserve(corners);
  lens.grid.y.reserve(corners);
  std::vector<Eigen::Vector2f> row;
  for (int y = 0; y <= camera.height; ++y) {
    lens.scale.CornerRow(y, ends, row);
    for (const Eigen::Vector2f& corner : row) {
      lens.grid.x.push_back(corner.x());
      lens.grid.y.push_back(corner.y());
    }
  }
}

}  // namespace

const KeptLens& KeptLenses::Of(const Camera& camera, const LensRipple& ripple, const Scene& scene,
                               const Pose3& X_WC) {
  const auto known = std::find_if(lenses_.begin(), lenses_.end(), [&](const auto& lens) {
    return lens->scale.camera() == camera && lens->scale.ripple() == ripple;
  });
  if (known != lenses_.end()) {
    std::rotate(lenses_.begin(), known, known + 1);
    if (lenses_.front()->scale.pupil_moves()) FillGrid(scene, X_WC, *lenses_.front());
    return *lenses_.front();
  }
  const TanScale scale(camera, ripple);
  auto lens =
      std::make_unique<KeptLens>(KeptLens{.scale = scale, .rect = ImageRect(camera, scale)});
  FillGrid(scene, X_WC, *lens);
  if (lenses_.size() == kMost) lenses_.pop_back();
  lenses_.insert(lenses_.begin(), std::move(lens));
  return *lenses_.front();
}

}  // namespace dockyard
