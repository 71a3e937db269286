// The thin bodies of a scene: tether and cables, drawn as tubes with cover.
#include <algorithm>
#include <cmath>

#include "render/scene_painter.h"

namespace dockyard {

SurfaceMesh ScenePainter::TetherTube(
    const TetherView& body, const std::function<double(const Eigen::Vector3d&)>& drawn) const {
  std::vector<Eigen::Vector3d> points_P;
  for (const Eigen::Vector3d& p : body.points_W) points_P.push_back(p - X_WP_.p);
  return Tube(points_P, 0.5 * body.diameter_m, drawn);
}

// The pixels that a thin body may touch.
bool ScenePainter::FitThin(const Frustum& frustum, const TetherView& body, ThinLayer& layer) const {
  const Pose3& X_CW = frustum.X_CW;
  const double px = (frustum.rect.right - frustum.rect.left) / frustum.width;
  const double py = (frustum.rect.bottom - frustum.rect.top) / frustum.height;
  Eigen::AlignedBox2d box;
  bool any = false;
  for (const Eigen::Vector3d& p_W : body.points_W) {
    const Eigen::Vector3d p_C = X_CW * p_W;
    if (p_C.z() < 2.0 * kNear_m) {  // may come up to the camera: anywhere
      box.extend(Eigen::Vector2d(frustum.rect.left, frustum.rect.top));
      box.extend(Eigen::Vector2d(frustum.rect.right, frustum.rect.bottom));
      continue;
    }
    any = true;
    const Eigen::Vector2d tan = p_C.head<2>() / p_C.z();
    const double reach = body.diameter_m / p_C.z() + 2.0 * std::max(px, py);
    box.extend(tan - Eigen::Vector2d::Constant(reach));
    box.extend(tan + Eigen::Vector2d::Constant(reach));
  }
  if (!any) return false;
  const auto pixel = [](double at, double from, double step, int last) {
    return static_cast<int>(std::clamp(std::floor((at - from) / step), 0.0, double(last)));
  };
  layer.x = pixel(box.min().x(), frustum.rect.left, px, frustum.width);
  layer.y = pixel(box.min().y(), frustum.rect.top, py, frustum.height);
  layer.width = pixel(box.max().x() + px, frustum.rect.left, px, frustum.width) - layer.x;
  layer.height = pixel(box.max().y() + py, frustum.rect.top, py, frustum.height) - layer.y;
  return layer.width > 0 && layer.height > 0;
}

void ScenePainter::PaintTether(const Frustum& frustum, const GlViewTarget& target,
                               const TetherView& body, ThinLayer& layer) {
  layer.thin.clear();
  layer.width = layer.height = 0;
  if (!FitThin(frustum, body, layer)) return;
  const Pose3 X_CP = frustum.X_CW * X_WP_;
  const double pixel = (frustum.rect.right - frustum.rect.left) / frustum.width;
  tether_mesh_.Upload(TetherTube(body, [&](const Eigen::Vector3d& p_P) {
    return 0.6 * pixel * std::max((X_CP * p_P).z(), 0.0);
  }));
  target.BindThin();
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(layer.x, layer.y, layer.width, layer.height);
  constexpr GLfloat kNone[4] = {0, 0, 0, 0};
  gl_.ClearBufferfv(GL_COLOR, 0, kNone);
  thin_.Use();
  Pose(thin_, frustum, X_WP_);
  thin_.Set("u_up", Eigen::Vector3d(fit_.X_WU.R.row(2).transpose()));
  gl_.Enable(GL_CULL_FACE);  // or the far side would count as cover too
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  tether_mesh_.Draw();
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_SCISSOR_TEST);
  layer.thin.resize(static_cast<std::size_t>(layer.width) * layer.height);
  target.Read(layer.x, layer.y, layer.width, layer.height, layer.thin.data());
}

}  // namespace dockyard
